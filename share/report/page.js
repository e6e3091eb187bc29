// SPDX-License-Identifier: GPL-3.0-or-later
// What the page does by itself: light or dark, and the values of the curves under the pointer.
(() => {
  const root = document.documentElement;
  const dark = matchMedia('(prefers-color-scheme: dark)');
  const button = document.getElementById('theme');
  const isDark = () => (root.dataset.theme ? root.dataset.theme === 'dark' : dark.matches);
  const tell = () => {
    button.textContent = isDark() ? 'Light' : 'Dark';
    document.dispatchEvent(new Event('themechange'));
  };
  button.hidden = false;
  button.addEventListener('click', () => {
    root.dataset.theme = isDark() ? 'light' : 'dark';
    tell();
  });
  dark.addEventListener('change', tell);
  tell();

  document.querySelectorAll('.images img').forEach((image) => {
    const change = () => image.closest('figure').classList.toggle('large');
    image.addEventListener('click', change);
    image.addEventListener('keydown', (event) => {
      if (event.key !== 'Enter' && event.key !== ' ') return;
      event.preventDefault();
      change();
    });
  });

  const shown = (value) => (Math.abs(value) >= 1e5 ? value.toExponential(2) : String(Number(value.toPrecision(4))));
  document.querySelectorAll('.chart').forEach((figure) => {
    const svg = figure.querySelector('svg');
    const frame = svg.querySelector('.frame');
    const cursor = svg.querySelector('.cursor');
    const nows = [...figure.querySelectorAll('.now')];
    const box = ['x', 'y', 'width', 'height'].map((name) => Number(frame.getAttribute(name)));
    const { x0, x1, y0, y1 } = Object.fromEntries(Object.entries(figure.dataset).map(([k, v]) => [k, Number(v)]));
    let lines; // read when first needed
    const value = (points, x) => {
      let k = points.findIndex((point) => point[0] >= x);
      if (k < 0) k = points.length - 1;
      const [a, b] = [points[Math.max(k - 1, 0)], points[k]];
      const share = b[0] > a[0] ? Math.min(Math.max((x - a[0]) / (b[0] - a[0]), 0), 1) : 1;
      return y0 + ((box[1] + box[3] - (a[1] + share * (b[1] - a[1]))) / box[3]) * (y1 - y0);
    };
    svg.addEventListener('pointermove', (event) => {
      lines ??= [...svg.querySelectorAll('.line')].map((line) =>
        line.getAttribute('points').split(' ').map((pair) => pair.split(',').map(Number)));
      const size = svg.getBoundingClientRect();
      const x = ((event.clientX - size.left) / size.width) * svg.viewBox.baseVal.width;
      if (x < box[0] || x > box[0] + box[2]) return;
      cursor.setAttribute('visibility', 'visible');
      cursor.setAttribute('transform', `translate(${x} 0)`);
      const time = x0 + ((x - box[0]) / box[2]) * (x1 - x0);
      figure.querySelector('figcaption').dataset.at = `${time.toFixed(3)} ms`;
      lines.forEach((points, k) => { nows[k].textContent = shown(value(points, x)); });
    });
    svg.addEventListener('pointerleave', () => {
      cursor.setAttribute('visibility', 'hidden');
      delete figure.querySelector('figcaption').dataset.at;
      nows.forEach((now) => { now.textContent = ''; });
    });
  });
})();

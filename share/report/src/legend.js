// SPDX-License-Identifier: GPL-3.0-or-later
// What the colours mean.
function element(name, className, text) {
  const made = document.createElement(name);
  if (className) made.className = className;
  if (text) made.textContent = text;
  return made;
}

// Boxes that show and hide the parts; hidden is the Set of their numbers, changed() is called after each change.
export function legendOfParts(parts, hidden, changed) {
  const list = element('fieldset', 'parts');
  list.append(element('legend', '', 'Parts of the bird'));
  parts.forEach((part, number) => {
    const label = element('label');
    const box = element('input');
    box.type = 'checkbox';
    box.checked = !hidden.has(number);
    box.addEventListener('change', () => {
      if (box.checked) hidden.delete(number);
      else hidden.add(number);
      changed();
    });
    const swatch = element('span', 'swatch');
    swatch.style.background = part.colour;
    label.append(box, swatch, part.name);
    list.append(label);
  });
  return list;
}

function short(value) {
  return Math.abs(value) >= 1e5 || (value !== 0 && Math.abs(value) < 1e-3) ? value.toExponential(2) : String(Number(value.toPrecision(3)));
}

// A bar with its ends, and a slider that moves the upper one; a value beyond it is told by the sign there. scale.share is
// the part of the field's range that the colours span, 0.05 to 1; changed() is called after each change.
export function legendOfField(field, colours, owner, scale, changed) {
  const box = element('div', 'bar');
  box.append(element('div', 'bar-title', `${owner}: ${field.title.toLowerCase()} [${field.unit}]`));
  const strip = element('div', 'bar-strip');
  strip.style.background = `linear-gradient(to right, ${colours.filter((_, k) => k % 15 === 0).join(', ')})`;
  const ends = element('div', 'bar-ends');
  ends.append(element('span'), element('span'), element('span'));
  const label = () => {
    const high = field.low + scale.share * (field.high - field.low);
    ends.children[0].textContent = short(field.low);
    ends.children[1].textContent = short((field.low + high) / 2);
    ends.children[2].textContent = `${field.beyond || scale.share < 1 ? '≥ ' : ''}${short(high)}`;
  };
  const slider = element('input', 'bar-slider');
  Object.assign(slider, { type: 'range', min: 0.05, max: 1, step: 0.05, value: scale.share, title: 'Upper end of the colours' });
  slider.setAttribute('aria-label', `Upper end of the colours of the ${owner.toLowerCase()}`);
  slider.addEventListener('input', () => {
    scale.share = Number(slider.value);
    label();
    changed();
  });
  label();
  box.append(strip, ends, slider);
  return box;
}

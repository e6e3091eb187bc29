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

// A bar with its ends; a value beyond the range is told by the sign at its upper end.
export function legendOfField(field, colours, owner) {
  const box = element('div', 'bar');
  box.append(element('div', 'bar-title', `${owner}: ${field.title.toLowerCase()} [${field.unit}]`));
  const strip = element('div', 'bar-strip');
  strip.style.background = `linear-gradient(to right, ${colours.filter((_, k) => k % 15 === 0).join(', ')})`;
  const ends = element('div', 'bar-ends');
  const middle = (field.low + field.high) / 2;
  ends.append(element('span', '', short(field.low)), element('span', '', short(middle)),
    element('span', '', `${field.beyond ? '≥ ' : ''}${short(field.high)}`));
  box.append(strip, ends);
  return box;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The view of a report: starts the scene, and joins it to the buttons of the page.
import { decode } from './decode.js';
import { Scene } from './scene.js';
import { legendOfParts, legendOfField } from './legend.js';
import { Player } from './player.js';

const $ = (name) => document.getElementById(name);

function hasWebGL() {
  try {
    return Boolean(document.createElement('canvas').getContext('webgl2'));
  } catch {
    return false;
  }
}

function option(select, value, text) {
  const one = document.createElement('option');
  one.value = value;
  one.textContent = text;
  select.append(one);
}

function sayThatItCannot(why) {
  $('view').classList.add('unable');
  $('view-message').textContent = why;
}

function start() {
  const data = decode($('view-data').textContent);
  const state = { frame: 0, colour: 'part', targetColour: '', hidden: new Set(), cut: false, showTarget: true, edges: true, scale: { share: 1 }, targetScale: { share: 1 } };
  const scene = new Scene(data, $('view-canvas'));
  const canvas = $('view-canvas').querySelector('canvas');
  canvas.setAttribute('role', 'img');
  canvas.setAttribute('aria-label', 'Bird and target in three dimensions; drag to turn');

  data.bird.fields.forEach((field) => option($('colour'), field.name, field.title));
  if (data.target) data.target.fields.forEach((field) => option($('target-colour'), field.name, field.title));
  else document.querySelectorAll('.of-target').forEach((element) => { element.hidden = true; });
  if (data.target?.field('displacement')) { // a target that bends
    state.targetColour = 'displacement';
    $('target-colour').value = state.targetColour;
  }

  const draw = () => scene.show(state);
  const drawLegends = () => {
    $('legend').replaceChildren(
      state.colour === 'part'
        ? legendOfParts(data.bird.parts, state.hidden, draw)
        : legendOfField(data.bird.field(state.colour), data.colourNames, 'Bird', state.scale, draw),
    );
    $('target-legend').replaceChildren(
      ...(state.targetColour && state.showTarget
        ? [legendOfField(data.target.field(state.targetColour), data.colourNames, 'Target', state.targetScale, draw)]
        : []),
    );
  };

  const time = $('time');
  time.max = data.times.length - 1;
  const showFrame = (frame) => {
    state.frame = frame;
    time.value = frame;
    const stamp = `${(1e3 * data.times[frame]).toFixed(3)} ms`;
    $('time-stamp').textContent = stamp;
    time.setAttribute('aria-valuetext', stamp);
    draw();
  };
  const player = new Player(data.times.length, showFrame, (plays) => {
    $('play').textContent = plays ? 'Pause' : 'Play';
    $('play').setAttribute('aria-pressed', plays);
    if (!plays) keepPictureSoon();
  });

  time.addEventListener('input', () => { player.stop(); showFrame(Number(time.value)); });
  $('play').addEventListener('click', () => player.toggle(state.frame));
  $('speed').addEventListener('change', () => { player.speed = Number($('speed').value); });
  player.speed = Number($('speed').value);
  $('colour').addEventListener('change', () => { state.colour = $('colour').value; state.scale.share = 1; drawLegends(); draw(); });
  $('target-colour').addEventListener('change', () => { state.targetColour = $('target-colour').value; state.targetScale.share = 1; drawLegends(); draw(); });
  const toggles = [['cut', 'cut'], ['show-target', 'showTarget'], ['edges', 'edges']];
  toggles.forEach(([id, name]) => {
    $(id).checked = state[name];
    $(id).addEventListener('change', () => { state[name] = $(id).checked; drawLegends(); draw(); });
  });
  document.querySelectorAll('[data-look]').forEach((button) => {
    button.addEventListener('click', () => scene.look(button.dataset.look));
  });

  const keys = {
    ' ': () => player.toggle(state.frame),
    ',': () => { player.stop(); showFrame(Math.max(0, state.frame - 1)); },
    '.': () => { player.stop(); showFrame(Math.min(data.times.length - 1, state.frame + 1)); },
    Home: () => { player.stop(); showFrame(0); },
    End: () => { player.stop(); showFrame(data.times.length - 1); },
    ArrowLeft: () => scene.turn(10, 0),
    ArrowRight: () => scene.turn(-10, 0),
    ArrowUp: () => scene.turn(0, -10),
    ArrowDown: () => scene.turn(0, 10),
    '+': () => scene.zoom(1.2),
    '-': () => scene.zoom(1 / 1.2),
    1: () => scene.look('iso'),
    2: () => scene.look('side'),
    3: () => scene.look('front'),
    4: () => scene.look('top'),
    c: () => $('cut').click(),
  };
  $('view-canvas').addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || !keys[event.key]) return;
    event.preventDefault();
    event.stopPropagation();
    keys[event.key]();
  });

  // The wheel is the page's until the view has been clicked.
  const stage = $('view-canvas').parentElement;
  stage.addEventListener('wheel', (event) => {
    if (!stage.contains(document.activeElement)) event.stopPropagation();
  }, { capture: true });
  $('view-canvas').addEventListener('pointerdown', () => $('view-canvas').focus({ preventScroll: true }), { capture: true });

  const paint = () => {
    const [r, g, b] = getComputedStyle($('view-canvas')).backgroundColor.match(/[\d.]+/g).map(Number);
    scene.background([r, g, b]);
  };
  document.addEventListener('themechange', paint);

  // What is on the screen is what is printed, on white. The picture is made ahead: a browser does not wait for it.
  const keepPicture = () => {
    if (!canvas.clientWidth) return;
    scene.background([255, 255, 255]);
    $('view-print').src = canvas.toDataURL(); // in the same task as the drawing, or it would be empty
    paint();
  };
  let soon = 0;
  const keepPictureSoon = () => {
    clearTimeout(soon);
    soon = setTimeout(keepPicture, 400);
  };
  $('view').addEventListener('input', keepPictureSoon);
  for (const event of ['pointerup', 'wheel', 'keyup', 'click']) $('view').addEventListener(event, keepPictureSoon);
  window.addEventListener('beforeprint', keepPicture);

  drawLegends();
  showFrame(0);
  scene.look('iso');
  paint();
  keepPicture();
  $('view').classList.add('ready');
}

if (!hasWebGL()) {
  sayThatItCannot('This browser shows no WebGL, which the view in three dimensions needs. The pictures below are of the same run.');
} else {
  try {
    start();
  } catch (error) {
    sayThatItCannot(`The view in three dimensions could not be started: ${error.message}. The pictures below are of the same run.`);
  }
}

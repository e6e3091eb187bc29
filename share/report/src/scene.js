// SPDX-License-Identifier: GPL-3.0-or-later
// Bird and target before a camera, in vtk.js: particles as spheres, the target as its elements.
import '@kitware/vtk.js/Rendering/OpenGL/Profiles/Geometry';
import '@kitware/vtk.js/Rendering/OpenGL/Profiles/Molecule';
import vtkActor from '@kitware/vtk.js/Rendering/Core/Actor';
import vtkDataArray from '@kitware/vtk.js/Common/Core/DataArray';
import vtkGenericRenderWindow from '@kitware/vtk.js/Rendering/Misc/GenericRenderWindow';
import vtkMapper from '@kitware/vtk.js/Rendering/Core/Mapper';
import vtkPolyData from '@kitware/vtk.js/Common/DataModel/PolyData';
import vtkSphereMapper from '@kitware/vtk.js/Rendering/Core/SphereMapper';

// Where the camera looks and what is up, as vtkio/scene.cpp has it.
const views = {
  side: [[0, 1, 0], [0, 0, 1]],
  front: [[1, 0, 0], [0, 0, 1]],
  top: [[0, 0, -1], [0, 1, 0]],
  iso: [[0.693, 0.597, -0.404], [0.306, 0.264, 0.915]],
};
const grey = [189, 196, 204];

// Colour of each of the 256 values of a field, where the colours span that share of its range.
const spread = (colours, share) => colours.map((_, value) => colours[Math.min(255, Math.round(value / share))]);

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

function colourArray(values) {
  return vtkDataArray.newInstance({ name: 'colour', numberOfComponents: 3, values });
}

export class Scene {
  // data: what decode() gives; container: an element with a size
  constructor(data, container) {
    this.data = data;
    this.window = vtkGenericRenderWindow.newInstance({ listenWindowResize: false });
    this.window.setContainer(container);
    this.renderer = this.window.getRenderer();
    this.renderer.getActiveCamera().setParallelProjection(true);
    this.places = new Float32Array(3 * data.bird.count);
    this.makeBird();
    if (data.target) this.makeTarget();
    this.window.resize();
    this.sizes = new ResizeObserver(() => this.resize());
    this.sizes.observe(container);
  }

  makeBird() {
    this.birdData = vtkPolyData.newInstance();
    this.birdMapper = vtkSphereMapper.newInstance({ radius: 0.62 * this.data.bird.spacing });
    this.birdMapper.setInputData(this.birdData);
    this.birdMapper.setColorModeToDirectScalars();
    this.bird = vtkActor.newInstance();
    this.bird.setMapper(this.birdMapper);
    this.bird.getProperty().setAmbient(0.45); // their dark rims must not outweigh the colours of small spheres
    this.bird.getProperty().setDiffuse(0.6);
    this.renderer.addActor(this.bird);
  }

  makeTarget() {
    this.targetPlaces = new Float32Array(3 * this.data.target.count);
    this.targetData = vtkPolyData.newInstance();
    this.targetMapper = vtkMapper.newInstance();
    this.targetMapper.setInputData(this.targetData);
    this.targetMapper.setColorModeToDirectScalars();
    this.target = vtkActor.newInstance();
    this.target.setMapper(this.targetMapper);
    const look = this.target.getProperty();
    look.setInterpolationToFlat();
    look.setAmbient(0.45);
    look.setDiffuse(0.55);
    look.setEdgeColor(0.45, 0.48, 0.52);
    look.setLineWidth(1);
    this.renderer.addActor(this.target);
  }

  // state: {frame, colour: 'part' or a field, targetColour: '' or a field, hidden: Set of parts, cut, showTarget, edges}
  show(state) {
    this.showBird(state);
    if (this.data.target) this.showTarget(state);
    this.render();
  }

  showBird({ frame, colour, hidden, cut, scale }) {
    const { bird } = this.data;
    const colours = spread(this.data.colours, scale.share);
    bird.positions(frame, this.places);
    const field = colour === 'part' ? null : bird.field(colour).at(frame);
    const ofPart = bird.parts.map(({ colour: c }) => [1, 3, 5].map((at) => parseInt(c.slice(at, at + 2), 16)));
    const points = new Float32Array(3 * bird.count);
    const rgb = new Uint8Array(3 * bird.count);
    let shown = 0;
    for (let i = 0; i < bird.count; ++i) {
      if (hidden.has(bird.part[i]) || (cut && this.places[3 * i + 1] < 0)) continue;
      const c = field ? colours[field[i]] : ofPart[bird.part[i]];
      for (let k = 0; k < 3; ++k) {
        points[3 * shown + k] = this.places[3 * i + k];
        rgb[3 * shown + k] = c[k];
      }
      ++shown;
    }
    this.birdData.getPoints().setData(points.slice(0, 3 * shown), 3);
    this.birdData.getPointData().setScalars(colourArray(rgb.slice(0, 3 * shown)));
    this.birdData.modified();
    this.bird.setVisibility(shown > 0);
  }

  showTarget({ frame, targetColour, cut, showTarget, edges, targetScale }) {
    const { target } = this.data;
    const colours = spread(this.data.colours, targetScale.share);
    this.target.setVisibility(showTarget);
    if (!showTarget) return;
    const places = target.positions(frame, this.targetPlaces).slice();
    const field = targetColour ? target.field(targetColour) : null;
    const values = field ? field.at(frame) : null;
    const faces = [];
    const rgb = [];
    this.standing(frame, (corners, cell) => {
      if (cut) { // elements whose middle lies behind the cut stay whole
        let middle = 0;
        corners.forEach((corner) => { middle += places[3 * corner + 1]; });
        if (middle < 0) return;
      }
      faces.push(corners.length, ...corners);
      if (!field || field.of === 'cells') rgb.push(...(field ? colours[values[cell]] : grey));
    });
    this.targetData.getPoints().setData(places, 3);
    this.targetData.getPolys().setData(Uint32Array.from(faces));
    const ofPoints = field && field.of === 'points';
    this.targetData.getCellData().setScalars(ofPoints ? null : colourArray(Uint8Array.from(rgb)));
    this.targetData.getPointData().setScalars(
      ofPoints ? colourArray(Uint8Array.from([...values].flatMap((value) => colours[value]))) : null,
    );
    if (ofPoints) this.targetMapper.setScalarModeToUsePointData();
    else this.targetMapper.setScalarModeToUseCellData();
    this.target.getProperty().setEdgeVisibility(edges);
    this.targetData.modified();
  }

  // Calls each(corners, number) for every element of the target that has not eroded.
  standing(frame, each) {
    const { faces, gone, cells } = this.data.target;
    for (let at = 0, cell = 0; at < faces.length; at += 1 + faces[at], ++cell)
      if (!gone || !gone[frame * cells + cell]) each(faces.subarray(at + 1, at + 1 + faces[at]), cell);
  }

  // Names of views as above; the camera holds the bird of the first frame, and the
  // target of all time.
  look(name) {
    const [direction, up] = views[name];
    const right = cross(direction, up);
    const axes = [right, up, direction];
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    const hold = (places, i) => {
      for (let k = 0; k < 3; ++k) {
        const x = dot(places.subarray(3 * i, 3 * i + 3), axes[k]);
        low[k] = Math.min(low[k], x);
        high[k] = Math.max(high[k], x);
      }
    };
    const { bird, target, times } = this.data;
    const places = bird.positions(0, new Float32Array(bird.row));
    for (let i = 0; i < bird.count; ++i) hold(places, i);
    for (const frame of target?.moves ? [0, times.length >> 1, times.length - 1] : [0])
      if (target) {
        const now = target.positions(frame, new Float32Array(target.row));
        this.standing(frame, (corners) => corners.forEach((i) => hold(now, i)));
      }
    const half = low.map((x, k) => (high[k] - x) / 2 + this.data.bird.spacing);
    const centre = [0, 1, 2].map((j) => axes.reduce((sum, axis, k) => sum + (axis[j] * (low[k] + high[k])) / 2, 0));
    const size = Math.hypot(...half);
    const [width, height] = this.window.getApiSpecificRenderWindow().getSize();
    const camera = this.renderer.getActiveCamera();
    camera.setFocalPoint(...centre);
    camera.setPosition(...centre.map((x, k) => x - 3 * size * direction[k]));
    camera.setViewUp(...up);
    camera.setParallelScale(1.06 * Math.max(half[1], (half[0] * height) / Math.max(width, 1)));
    this.renderer.resetCameraClippingRange();
    this.render();
  }

  // Turn by degrees about the vertical and the horizontal of the picture.
  turn(azimuth, elevation) {
    const camera = this.renderer.getActiveCamera();
    camera.azimuth(azimuth);
    camera.elevation(elevation);
    camera.orthogonalizeViewUp();
    this.render();
  }

  zoom(factor) {
    this.renderer.getActiveCamera().zoom(factor);
    this.render();
  }

  background(rgb) {
    this.renderer.setBackground(...rgb.map((c) => c / 255));
    this.render();
  }

  resize() {
    if (!this.window.getContainer().clientWidth) return; // hidden, as on paper
    this.window.resize();
    this.render();
  }

  render() {
    this.renderer.resetCameraClippingRange();
    this.window.getRenderWindow().render();
  }
}

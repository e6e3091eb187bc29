// SPDX-License-Identifier: GPL-3.0-or-later
// Plays frames one after the other.
const framesPerSecond = 10; // at speed 1

export class Player {
  // show(frame) is called for each frame, changed(plays) when it starts and stops
  constructor(count, show, changed) {
    Object.assign(this, { count, show, changed, speed: 1, running: 0 });
  }

  toggle(frame) {
    if (this.running) {
      this.stop();
      return;
    }
    this.place = frame >= this.count - 1 ? 0 : frame;
    this.before = performance.now();
    this.changed(true);
    const step = (now) => {
      this.place += ((now - this.before) / 1000) * framesPerSecond * this.speed;
      this.before = now;
      const last = this.place >= this.count - 1;
      const frame = last ? this.count - 1 : Math.floor(this.place);
      if (frame !== this.shown) this.show(frame);
      this.shown = frame;
      if (last) this.stop();
      else this.running = requestAnimationFrame(step);
    };
    this.shown = -1;
    this.running = requestAnimationFrame(step);
  }

  stop() {
    if (!this.running) return;
    cancelAnimationFrame(this.running);
    this.running = 0;
    this.changed(false);
  }
}

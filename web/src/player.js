/// Time: a slider over the frames, and play.
import { element } from "./dom.js";

const SECONDS_PER_RUN = 6; // a whole run, but no faster than a browser draws
const SHORTEST = 60; // milliseconds per frame

export class Player {
  constructor(frames, show) {
    this.frames = frames;
    this.show = show;
    this.slider = element("input", {
      id: "time",
      type: "range",
      min: 0,
      max: frames.length - 1,
      value: frames.length - 1,
      "aria-label": "time",
      input: () => this.choose(Number(this.slider.value)),
    });
    this.button = element(
      "button",
      { id: "play", type: "button", click: () => this.toggle() },
      "▶ Play",
    );
    this.words = element("output", { id: "time-text" });
    this.controls = element("div", { class: "player" }, this.button, this.slider, this.words);
    this.controls.hidden = frames.length < 2;
  }

  go(n) {
    this.slider.value = n;
    this.words.textContent = this.show(n);
  }

  /// A frame that the user asks for: the film stops there.
  choose(n) {
    this.stop();
    this.go(n);
  }

  toggle() {
    if (this.timer) return this.stop();
    this.button.textContent = "❚❚ Pause";
    const pause = Math.max(SHORTEST, (1000 * SECONDS_PER_RUN) / this.frames.length);
    if (Number(this.slider.value) === this.frames.length - 1) this.go(0);
    this.timer = setInterval(() => this.step(), pause);
  }

  step() {
    const next = Number(this.slider.value) + 1;
    this.go(next);
    if (next === this.frames.length - 1) this.stop();
  }

  stop() {
    clearInterval(this.timer);
    this.timer = null;
    this.button.textContent = "▶ Play";
  }
}

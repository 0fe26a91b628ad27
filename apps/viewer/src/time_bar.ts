// The bar that goes through the moments of the page's time, where it has some. While it plays, frames are asked for;
// else nothing is.
import type { Time } from './data';
import { element } from './panels';
import type { State } from './state';

export class TimeBar {
  private playing = false;
  private started = 0; // when the moment that it began with was shown
  private startedAt = 0; // that moment

  constructor(
    private readonly time: Time | undefined,
    private readonly state: State,
    private readonly changed: () => void,
  ) {
    if (!time) return;
    element('time').hidden = false;
    const slider = element<HTMLInputElement>('moment');
    slider.max = String(time.moments.length - 1);
    slider.oninput = () => {
      const moment = Number(slider.value);
      this.pause();
      this.go(moment);
    };
    this.tell();
  }

  /// One that is not there is the nearest that is.
  go(moment: number): void {
    if (!this.time) return;
    this.state.moment = Math.max(0, Math.min(this.time.moments.length - 1, moment));
    this.tell();
    this.changed();
  }

  step(by: number): void {
    if (!this.time) return;
    this.pause();
    this.go(this.state.moment + by);
  }

  /// From the beginning where it stands at the end.
  toggle(): void {
    if (!this.time) return;
    if (this.playing) return this.pause();
    this.playing = true;
    if (this.state.moment === this.time.moments.length - 1) this.go(0);
    this.startedAt = this.state.moment;
    this.started = performance.now();
    this.tell();
    requestAnimationFrame((now) => this.tick(now));
  }

  private pause(): void {
    this.playing = false;
    this.tell();
  }

  private tick(now: number): void {
    if (!this.playing || !this.time) return;
    const moment = this.startedAt + Math.floor((Math.max(0, now - this.started) * this.time.per_second) / 1000);
    if (moment !== this.state.moment) this.go(moment);
    if (this.state.moment >= this.time.moments.length - 1) this.pause();
    else requestAnimationFrame((next) => this.tick(next));
  }

  private tell(): void {
    if (!this.time) return;
    const { label, note } = this.time.moments[this.state.moment];
    const text = note ? `${label}: ${note}` : label;
    const slider = element<HTMLInputElement>('moment');
    slider.value = String(this.state.moment);
    slider.setAttribute('aria-valuetext', text);
    element('moment-text').textContent = text;
    element('play').textContent = this.playing ? 'Pause' : 'Play';
  }
}

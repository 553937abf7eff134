// Play, time slider, events, rate, follow.
import { el, svg } from '../../dom';
import type { PullEvent } from '../../data';
import { type Playback, RATES } from '../states/playback';
import { timeText } from '../states/quantity';

export interface PlayerActions {
  toggle(): void;
  seek(time: number): void;
  /** One event on (1) or back (-1). */
  event(step: number): void;
  follow(on: boolean): void;
}

/** Drawn on 16 x 16: fonts do not all have the signs. */
const SIGNS = {
  play: 'M4 2.5v11l9-5.5z',
  pause: 'M4 3h3v10H4zM9 3h3v10H9z',
  before: 'M3 3h2v10H3zM13 3v10L6 8z',
  next: 'M11 3h2v10h-2zM3 3v10l7-5z',
};

const sign = (path: string): SVGSVGElement =>
  svg(
    'svg',
    { width: 14, height: 14, viewBox: '0 0 16 16', 'aria-hidden': 'true' },
    svg('path', { d: path, fill: 'currentColor' }),
  );

/** A button with a sign; the name is for those who do not see it, the keys do the same. */
const signed = (path: string, name: string, keys: string, onclick: () => void): HTMLButtonElement =>
  el(
    'button',
    { type: 'button', 'aria-label': name, title: `${name} (${keys})`, 'aria-keyshortcuts': keys, onclick },
    sign(path),
  );

/** Divisions of the slider. */
const FINE = 4000;

export class PlayerBar {
  readonly root: HTMLElement;
  private readonly play: HTMLButtonElement;
  private readonly rates: HTMLSelectElement;
  private readonly slider = el('input', { type: 'range', min: 0, max: FINE, step: 'any', class: 'view-time' });
  private readonly reading = el('output', { class: 'view-reading' });
  private readonly followBox = el('input', { type: 'checkbox' });

  constructor(
    private readonly playback: Playback,
    events: readonly PullEvent[],
    actions: PlayerActions,
  ) {
    this.play = signed(SIGNS.play, 'Play', 'Space', () => actions.toggle());
    this.slider.setAttribute('aria-label', 'Simulated time');
    this.slider.addEventListener('input', () => actions.seek(this.timeOf(this.slider.valueAsNumber)));
    this.followBox.addEventListener('change', () => actions.follow(this.followBox.checked));
    const rates = (this.rates = el(
      'select',
      { title: 'Simulated seconds a second' },
      ...RATES.map((rate) => el('option', { value: rate }, `${rate}\u00d7`)),
    ));
    rates.value = String(playback.rate);
    rates.addEventListener('change', () => (playback.rate = Number(rates.value)));
    const jump = el(
      'select',
      { class: 'view-jump', 'aria-label': 'Jump to an event' },
      el('option', { value: '' }, 'Jump to\u2026'),
      ...events.map((event, i) =>
        el('option', { value: i }, `${timeText(event.time_s, playback.to)}  ${event.what.slice(0, 80)}`),
      ),
    );
    jump.addEventListener('change', () => {
      const event = events[Number(jump.value)];
      if (jump.value && event) actions.seek(event.time_s);
      jump.value = '';
    });
    const track = el('div', { class: 'view-track' }, this.slider, this.ticks(events));
    this.root = el(
      'div',
      { class: 'view-player' },
      this.play,
      signed(SIGNS.before, 'Event before', 'Shift+E', () => actions.event(-1)),
      signed(SIGNS.next, 'Next event', 'E', () => actions.event(1)),
      track,
      this.reading,
      el('label', { class: 'view-field' }, 'Speed', rates),
      jump,
      el('label', { class: 'view-field', title: 'Camera goes with the head (F)' }, this.followBox, 'Follow head'),
    );
  }

  private timeOf(value: number): number {
    const { from, to } = this.playback;
    return from + ((to - from) * value) / FINE;
  }

  private ticks(events: readonly PullEvent[]): HTMLElement {
    const { from, to } = this.playback;
    return el(
      'div',
      { class: 'view-ticks', 'aria-hidden': 'true' },
      ...events.map((event) => {
        const tick = el('i');
        tick.style.left = `${(100 * (event.time_s - from)) / Math.max(1e-9, to - from)}%`;
        return tick;
      }),
    );
  }

  /** Shows time and state of the playback. */
  update(): void {
    const { time, from, to, playing } = this.playback;
    this.slider.valueAsNumber = (FINE * (time - from)) / Math.max(1e-9, to - from);
    const text = timeText(time, to);
    if (this.reading.textContent !== text) {
      this.reading.textContent = text;
      this.slider.setAttribute('aria-valuetext', text);
    }
    const name = playing ? 'Pause' : 'Play';
    if (this.play.getAttribute('aria-label') === name) return;
    this.play.replaceChildren(sign(playing ? SIGNS.pause : SIGNS.play));
    this.play.setAttribute('aria-label', name);
  }

  following(on: boolean): void {
    this.followBox.checked = on;
  }

  /** Shows another rate. */
  rated(): void {
    this.rates.value = String(this.playback.rate);
  }
}

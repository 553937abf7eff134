/** Along the route, one under another over the same places: profile, tension both ways with what is allowed, sidewall pressure. */
import { el, svg } from '../dom';
import { tickLabels, ticks } from '../figure/ranges';
import { scaleOf, type Unit } from '../units';
import { quantity, type Desk } from './desk';
import { Drags } from './drag';
import type { Along } from './engine';
import { handles, sample, type Spot } from './handles';
import { t } from './words';

const LEFT = 62;
const RIGHT = 16;
const BELOW = 22;
const TOP = 20;
const REACH = 2.5; // an allowed value above so many times the largest is said, not drawn

interface Curve {
  name: string;
  className: string;
  values: (number | null)[];
}

class Strip {
  readonly drawing: SVGSVGElement;
  readonly drags: Drags;
  /** What is allowed, in words; it stands in the heading. */
  readonly limit = el('span', { class: 'limit' });
  private readonly pointer = svg('path', { class: 'pointer line', visibility: 'hidden' });
  private range: [number, number] = [0, 1];
  private length = 1;
  private wide = 300;

  constructor(
    private readonly desk: Desk,
    private readonly high: number,
    private readonly title: string,
    preview: (text: string | null, spot: Spot | null) => void,
  ) {
    this.drawing = svg('svg', { class: 'strip', height: high, tabindex: 0, role: 'group' });
    this.drags = new Drags(
      desk,
      { root: this.drawing, spot: (event) => this.spot(event), pixel: (spot) => this.pixel(spot) },
      preview,
    );
    this.drawing.addEventListener('pointermove', (event) => {
      if (this.drags.active) return;
      const [s] = this.spot(event);
      desk.place.mark(s < 0 || s > this.length ? null : s);
    });
    this.drawing.addEventListener('pointerleave', () => desk.place.mark(null));
    this.drawing.addEventListener('keydown', (event) => {
      const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      if (!step) return;
      event.preventDefault();
      desk.place.mark(Math.min(this.length, Math.max(0, (desk.place.at ?? 0) + (step * this.length) / 100)));
    });
    desk.place.follow(() => this.point());
  }

  private spot(event: PointerEvent): Spot {
    const box = this.drawing.getBoundingClientRect();
    const [low, high] = this.range;
    const room = this.high - TOP - BELOW;
    return [
      ((event.clientX - box.left - LEFT) / (this.wide - LEFT - RIGHT)) * this.length,
      low + (1 - (event.clientY - box.top - TOP) / room) * (high - low),
    ];
  }

  private pixel([s, value]: Spot): Spot {
    const [low, high] = this.range;
    return [
      LEFT + (s / this.length) * (this.wide - LEFT - RIGHT),
      TOP + (1 - (value - low) / (high - low)) * (this.high - TOP - BELOW),
    ];
  }

  private point(): void {
    const s = this.desk.place.at;
    this.pointer.setAttribute('visibility', s === null ? 'hidden' : 'visible');
    if (s === null) return;
    const [x] = this.pixel([s, 0]);
    this.pointer.setAttribute('d', `M${x.toFixed(1)} ${TOP}V${this.high - BELOW}`);
  }

  show(
    along: Along | undefined,
    unit: Unit,
    curves: Curve[],
    allowed: number | null,
    wide: number,
    text: string | null,
  ): void {
    const focus = this.drags.label;
    this.wide = wide;
    this.drawing.setAttribute('width', String(wide));
    this.drawing.setAttribute('aria-label', `${t(this.title)}. ${t('Arrow keys mark a place.')}`);
    if (!along) {
      this.drawing.replaceChildren();
      return;
    }
    this.limit.textContent = allowed === null ? '' : `${t('allowed')} ${quantity(allowed, unit, this.desk.us())}`;
    this.length = along.s_m.at(-1) ?? 1;
    const all = curves.flatMap(({ values }) => values).filter((value) => value !== null);
    const most = Math.max(...all);
    const drawn = allowed !== null && allowed <= REACH * most;
    if (!this.drags.active) this.range = this.ranged(all, drawn ? allowed : null, unit);
    const scale = scaleOf(unit, this.desk.us() ? 'us' : 'si', most);
    const parts: SVGElement[] = [...this.frame(scale.factor, scale.symbol, curves)];
    if (drawn) {
      const [, y] = this.pixel([0, allowed]);
      parts.push(svg('path', { class: 'allowed', d: `M${LEFT} ${y.toFixed(1)}H${wide - RIGHT}` }));
    }
    for (const { className, values } of curves) {
      const d = values
        .map((value, i) =>
          value === null
            ? ''
            : this.pixel([along.s_m[i] ?? 0, value])
                .map((v) => v.toFixed(1))
                .join(' '),
        )
        .filter(Boolean)
        .join('L');
      parts.push(svg('path', { class: `curve ${className}`, d: `M${d}` }));
    }
    const own = text === null ? [] : handles(text, along).filter((one) => one.view === 'profile');
    this.drawing.replaceChildren(...parts, this.pointer, ...this.drags.draw(own));
    this.point();
    if (!this.drags.active) this.drags.refocus(focus);
  }

  private ranged(all: number[], allowed: number | null, unit: Unit): [number, number] {
    const [low, high] = [Math.min(...all), Math.max(...all, allowed ?? -Infinity)];
    if (unit !== 'm') return [Math.min(0, low), high > 0 ? 1.08 * high : 1];
    const room = Math.max(0.1 * (high - low), 0.02 * this.length);
    return [low - room, high + room];
  }

  private frame(factor: number, symbol: string, curves: Curve[]): SVGElement[] {
    const [low, high] = this.range;
    const metres = scaleOf('m', this.desk.us() ? 'us' : 'si', 1);
    const across = ticks(0, this.length * metres.factor, Math.max(2, this.wide / 90));
    const up = ticks(low * factor, high * factor, 3);
    const upLabels = tickLabels(up);
    const acrossLabels = tickLabels(across);
    const room = this.high - BELOW;
    let x = LEFT;
    const legend =
      curves.length < 2
        ? []
        : curves.flatMap(({ name, className }) => {
            const at = x;
            x += 34 + 9 * name.length * (/[\u4e00-\u9fff]/.test(name) ? 1.6 : 0.8);
            return [
              svg('path', { class: `curve ${className}`, d: `M${at} 11H${at + 20}` }),
              svg('text', { x: at + 25, y: 15 }, name),
            ];
          });
    return [
      ...up.flatMap((value, i) => {
        const [, y] = this.pixel([0, value / factor]);
        return [
          svg('path', { class: 'grid', d: `M${LEFT} ${y.toFixed(1)}H${this.wide - RIGHT}` }),
          svg('text', { x: LEFT - 6, y: (y + 4).toFixed(1), 'text-anchor': 'end' }, upLabels[i]),
        ];
      }),
      ...across.map((value, i) => {
        const [at] = this.pixel([value / metres.factor, 0]);
        return svg('text', { x: at.toFixed(1), y: room + 15, 'text-anchor': 'middle' }, acrossLabels[i]);
      }),
      svg('text', { x: 4, y: 15, class: 'unit' }, symbol),
      svg('text', { x: 4, y: room + 15, class: 'unit' }, metres.symbol),
      ...legend,
    ];
  }
}

export class Strips {
  readonly root: HTMLElement;
  private readonly strips: [Strip, Strip, Strip];
  private readonly reading = el('p', { class: 'reading' });
  private shown: Along | undefined;
  private still = true;

  constructor(
    private readonly desk: Desk,
    preview: (text: string | null, spot: Spot | null) => void,
  ) {
    this.strips = [
      new Strip(desk, 84, 'Profile', preview),
      new Strip(desk, 140, 'Tension', preview),
      new Strip(desk, 100, 'Sidewall pressure', preview),
    ];
    const names = ['Profile', 'Tension at speed, the route full of cable', 'Sidewall pressure at speed'];
    this.root = el(
      'div',
      { class: 'strips' },
      ...this.strips.flatMap((strip, i) => [
        el('h3', {}, el('span', { 'data-t': names[i] ?? '' }, t(names[i] ?? '')), strip.limit),
        strip.drawing,
      ]),
      this.reading,
    );
    desk.place.follow(() => this.say());
    new ResizeObserver(() => this.redraw()).observe(this.root);
  }

  get dragging(): boolean {
    return this.strips.some((strip) => strip.drags.active);
  }

  show(along: Along | undefined, still = true): void {
    this.shown = along;
    this.still = still;
    this.redraw();
  }

  private limit(name: string): number | null {
    const limits = this.desk.theory()?.limits ?? [];
    return limits.find((one) => one.name === name && one.direction === 'forward')?.limit ?? null;
  }

  private redraw(): void {
    const along = this.shown;
    const wide = Math.max(240, this.root.clientWidth);
    const both = (forward: (number | null)[], backward: (number | null)[]): Curve[] => [
      { name: t('pulled forward'), className: 'forward', values: forward },
      { name: t('pulled back'), className: 'backward', values: backward },
    ];
    const [profile, tension, sidewall] = this.strips;
    const text = this.still && !this.dragging ? this.desk.text() : null;
    profile.show(along, 'm', along ? [{ name: '', className: 'height', values: along.z_m }] : [], null, wide, text);
    tension.show(along, 'N', along ? both(along.forward_N, along.backward_N) : [], this.limit('pull'), wide, null);
    sidewall.show(
      along,
      'N/m',
      along ? both(along.forward_sidewall_N_per_m, along.backward_sidewall_N_per_m) : [],
      this.limit('sidewall'),
      wide,
      null,
    );
    this.say();
  }

  /** What is at the marked place, in words. */
  private say(): void {
    const s = this.desk.place.at;
    const along = this.shown;
    if (s === null || !along) {
      this.reading.textContent = along ? t('A place that you point at is marked in table, plan and figures.') : '';
      return;
    }
    const us = this.desk.us();
    const at = (values: (number | null)[]): number => sample(along.s_m, values, s);
    const piece = along.pieces.find((one) => s >= one.s_m && s <= one.s_m + one.length_m);
    this.reading.textContent = [
      `${quantity(s, 'm', us)}${piece?.name ? ` (${piece.name})` : ''}`,
      `${t('height')} ${quantity(Math.round(1e3 * at(along.z_m)) / 1e3, 'm', us)}`,
      `${t('pulled forward')} ${quantity(at(along.forward_N), 'N', us)}, ${quantity(at(along.forward_sidewall_N_per_m), 'N/m', us)}`,
      `${t('pulled back')} ${quantity(at(along.backward_N), 'N', us)}, ${quantity(at(along.backward_sidewall_N_per_m), 'N/m', us)}`,
    ].join(' · ');
  }
}

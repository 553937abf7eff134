/** The route from above, to scale, with what stands along it and handles; it can be moved and zoomed. */
import { el, svg } from '../dom';
import { ticks } from '../figure/ranges';
import { quantity, type Desk } from './desk';
import { Drags } from './drag';
import type { Along, Stand } from './engine';
import { handles, nearest, spotAt, type Handle, type Spot } from './handles';
import { t } from './words';

const HIGH = 220;
const NAMED = 24;

/** What is to be seen: px a metre, and the place in the middle. */
interface Window {
  scale: number;
  middle: Spot;
}

/** Everything of a route, with so much room around it. */
function whole(along: Along, wide: number, high: number): Window {
  const [left, right] = [Math.min(...along.x_m), Math.max(...along.x_m)];
  const [low, up] = [Math.min(...along.y_m), Math.max(...along.y_m)];
  const scale = Math.min(wide / Math.max(right - left, 1), high / Math.max(up - low, 1));
  return { scale, middle: [(left + right) / 2, (low + up) / 2] };
}

/** The line, its bends stronger. */
function lines(along: Along, pixel: (spot: Spot) => Spot): SVGElement[] {
  const path = (from: number, to: number): string =>
    along.s_m
      .map((s, i): [number, Spot] => [s, [along.x_m[i] ?? 0, along.y_m[i] ?? 0]])
      .filter(([s]) => s >= from && s <= to)
      .map(([, spot]) =>
        pixel(spot)
          .map((v) => v.toFixed(1))
          .join(' '),
      )
      .join('L');
  const bends = along.pieces
    .filter((piece) => piece.kind !== 'straight' && piece.length_m > 0)
    .map((piece) => path(piece.s_m - 1e-6, piece.s_m + piece.length_m + 1e-6))
    .filter((d) => d.includes('L'));
  return [
    svg('path', { class: 'route', d: `M${path(0, Infinity)}` }),
    ...bends.map((d) => svg('path', { class: 'route bend', d: `M${d}` })),
  ];
}

function stand(one: Stand, [x, y]: Spot, us: boolean): SVGElement {
  const over = one.margin_pct !== null && one.margin_pct < 0;
  const small = one.kind === 'roller' || one.kind === 'guide' || one.kind === 'hold-down';
  return svg(
    'path',
    {
      class: `stand ${one.kind}${over ? ' over' : ''}`,
      transform: `translate(${x.toFixed(1)} ${y.toFixed(1)})`,
      d: small ? 'M-2 0H2M0 -2V2' : 'M-5 -5H5V5H-5z',
    },
    svg('title', {}, `${one.name}: ${quantity(one.load_N, 'N', us)}`),
  );
}

/** A small picture of a plan, which nobody works with. */
export function picture(along: Along, wide: number, high: number): SVGElement {
  const { scale, middle } = whole(along, wide - 24, high - 24);
  const pixel = ([x, y]: Spot): Spot => [wide / 2 + (x - middle[0]) * scale, high / 2 - (y - middle[1]) * scale];
  const stands = along.stands.equipment.map((one) => stand(one, pixel([one.x_m, one.y_m]), false));
  return svg(
    'svg',
    { class: 'picture', viewBox: `0 0 ${wide} ${high}`, 'aria-hidden': 'true' },
    ...lines(along, pixel),
    ...stands,
  );
}

export class Plan {
  readonly root: HTMLElement;
  private readonly drawing: SVGSVGElement;
  private readonly pointer = svg('circle', { r: 6, class: 'pointer', visibility: 'hidden' });
  private readonly drags: Drags;
  private scale = 0; // px a metre; 0: everything is to be seen
  private middle: Spot = [0, 0];
  private pan: { from: Spot; middle: Spot } | null = null;
  private shown: Along | undefined; // also that of a drag
  private still: Along | undefined; // that of the text
  private under: Spot[][] = []; // lines of the drawing that the route came from

  constructor(
    private readonly desk: Desk,
    preview: (text: string | null, spot: Spot | null) => void,
  ) {
    this.drawing = svg('svg', { class: 'plan', height: HIGH, tabindex: 0, role: 'group' });
    const tool = (label: string, title: string, action: () => void): HTMLElement =>
      el(
        'button',
        { type: 'button', onclick: action, 'data-t-label': title, 'aria-label': t(title), title: t(title) },
        label,
      );
    this.root = el(
      'div',
      { class: 'board' },
      this.drawing,
      el(
        'div',
        { class: 'zoom' },
        tool('+', 'Zoom in', () => this.zoom(1.5)),
        tool('−', 'Zoom out', () => this.zoom(1 / 1.5)),
        tool('⤢', 'Show all', () => this.all()),
      ),
    );
    this.drags = new Drags(
      desk,
      { root: this.drawing, spot: (event) => this.spot(event), pixel: (spot) => this.pixel(spot) },
      preview,
    );
    this.drawing.addEventListener('pointerdown', (event) => {
      if (event.button === 0) this.pan = { from: [event.clientX, event.clientY], middle: this.middle };
    });
    this.drawing.addEventListener('pointermove', (event) => this.hover(event));
    for (const end of ['pointerup', 'pointerleave', 'pointercancel'] as const)
      this.drawing.addEventListener(end, () => (this.pan = null));
    this.drawing.addEventListener('pointerleave', () => desk.place.mark(null));
    this.drawing.addEventListener(
      'wheel',
      (event) => {
        if (!event.ctrlKey && !event.metaKey && !this.drawing.contains(document.activeElement)) return; // the page scrolls
        event.preventDefault();
        this.zoom(event.deltaY < 0 ? 1.2 : 1 / 1.2, this.spot(event));
      },
      { passive: false },
    );
    this.drawing.addEventListener('keydown', (event) => this.key(event));
    desk.place.follow(() => this.point());
    new ResizeObserver(() => this.redraw()).observe(this.root);
  }

  get dragging(): boolean {
    return this.drags.active !== null;
  }

  show(along: Along | undefined, still = true): void {
    this.shown = along;
    if (still) this.still = along;
    this.redraw();
  }

  /** Lines that lie under the route, in the case's coordinates. */
  lay(under: Spot[][]): void {
    this.under = under;
    this.redraw();
  }

  private wide(): number {
    return Math.max(240, this.root.clientWidth);
  }

  private spot(event: MouseEvent): Spot {
    const box = this.drawing.getBoundingClientRect();
    return [
      (event.clientX - box.left - this.wide() / 2) / this.scale + this.middle[0],
      -(event.clientY - box.top - HIGH / 2) / this.scale + this.middle[1],
    ];
  }

  private pixel([x, y]: Spot): Spot {
    return [(x - this.middle[0]) * this.scale + this.wide() / 2, HIGH / 2 - (y - this.middle[1]) * this.scale];
  }

  private fitted = true;

  private fit(): void {
    const along = this.still;
    if (!along) return;
    // the buttons are above, names beside and below
    ({ scale: this.scale, middle: this.middle } = whole(along, this.wide() - 90, HIGH - 104));
    this.middle[1] += 10 / this.scale;
  }

  private all(): void {
    this.fitted = true;
    this.redraw();
  }

  private zoom(by: number, about: Spot = this.middle): void {
    this.fitted = false;
    this.scale = Math.min(1000, Math.max(1e-4, this.scale * by));
    this.middle = [about[0] + (this.middle[0] - about[0]) / by, about[1] + (this.middle[1] - about[1]) / by];
    this.redraw();
  }

  private key(event: KeyboardEvent): void {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    const length = this.still?.s_m.at(-1) ?? 0;
    if (step) this.desk.place.mark(Math.min(length, Math.max(0, (this.desk.place.at ?? 0) + (step * length) / 100)));
    else if (event.key === '+' || event.key === '=') this.zoom(1.5);
    else if (event.key === '-') this.zoom(1 / 1.5);
    else if (event.key === '0') this.all();
    else return;
    event.preventDefault();
  }

  private hover(event: PointerEvent): void {
    if (!this.still || this.drags.active) return;
    if (this.pan && event.buttons) {
      this.fitted = false;
      this.middle = [
        this.pan.middle[0] - (event.clientX - this.pan.from[0]) / this.scale,
        this.pan.middle[1] + (event.clientY - this.pan.from[1]) / this.scale,
      ];
      this.redraw();
      return;
    }
    const spot = this.spot(event);
    const s = nearest(this.still, spot);
    const [x, y] = this.pixel(spotAt(this.still, s));
    const [px, py] = this.pixel(spot);
    this.desk.place.mark(Math.hypot(x - px, y - py) < 40 ? s : null);
  }

  private point(): void {
    const s = this.desk.place.at;
    this.pointer.setAttribute('visibility', s === null || !this.shown ? 'hidden' : 'visible');
    if (s === null || !this.shown) return;
    const [x, y] = this.pixel(spotAt(this.shown, s));
    this.pointer.setAttribute('cx', x.toFixed(1));
    this.pointer.setAttribute('cy', y.toFixed(1));
  }

  private redraw(): void {
    const along = this.shown;
    const focus = this.drags.label;
    const wide = this.wide();
    this.drawing.setAttribute('width', String(wide));
    this.drawing.setAttribute(
      'aria-label',
      `${t('Plan')}. ${t('Arrow keys mark a place, plus and minus zoom, 0 shows all; handles are reached by Tab and moved by arrow keys.')}`,
    );
    if (!along) {
      this.drawing.replaceChildren();
      return;
    }
    if (this.fitted && !this.drags.active) this.fit();
    const under = this.under.map((line) =>
      svg('path', {
        class: 'under',
        d: `M${line
          .map((spot) =>
            this.pixel(spot)
              .map((v) => v.toFixed(1))
              .join(' '),
          )
          .join('L')}`,
      }),
    );
    const parts: SVGElement[] = [...under, this.ruler(), ...lines(along, (spot) => this.pixel(spot))];
    const stands = along.stands.equipment.map((one) => stand(one, this.pixel([one.x_m, one.y_m]), this.desk.us()));
    parts.push(...stands, ...this.names(along), this.arrow(along));
    const shown: Handle[] = this.drags.active || !this.still ? [] : handles(this.desk.text(), this.still);
    parts.push(this.pointer, ...this.drags.draw(shown.filter((one) => one.view === 'plan')));
    this.drawing.replaceChildren(...parts);
    this.point();
    if (!this.drags.active) this.drags.refocus(focus);
  }

  /** A bar of a round length. */
  private ruler(): SVGElement {
    const size = ticks(0, 140 / this.scale, 2).at(-1) || 1;
    const px = size * this.scale;
    return svg(
      'g',
      { class: 'ruler', transform: `translate(14 ${HIGH - 14})` },
      svg('path', { d: `M0 -5V0H${px.toFixed(1)}V-5` }),
      svg('text', { x: px + 6, y: 2 }, quantity(size, 'm', this.desk.us(), 3)),
    );
  }

  private names(along: Along): SVGElement[] {
    const bends = along.pieces.filter((piece) => piece.kind !== 'straight');
    const label = (s: number, words: string, dy: number): SVGElement => {
      const [x, y] = this.pixel(spotAt(along, s));
      const late = x > this.wide() - 20 - 7 * words.length; // it would be cut off
      const at = { x: (x + (late ? -12 : 12)).toFixed(1), y: (y + dy).toFixed(1) };
      return svg('text', { ...at, 'text-anchor': late ? 'end' : 'start' }, words);
    };
    return [
      label(0, t('start'), -10),
      label(along.s_m.at(-1) ?? 0, t('end'), -10),
      ...(bends.length > NAMED ? [] : bends).map((piece) =>
        label(
          piece.s_m + piece.length_m / 2,
          `${piece.name} R ${quantity(piece.radius_m, 'm', this.desk.us(), 3)}, ${piece.angle_deg.toPrecision(3)}°`,
          18,
        ),
      ),
    ];
  }

  /** Which way is forward. */
  private arrow(along: Along): SVGElement {
    const s = (along.s_m.at(-1) ?? 0) / 2;
    const [x, y] = this.pixel(spotAt(along, s));
    const [nx, ny] = this.pixel(spotAt(along, s + (along.s_m[1] ?? 1)));
    const turn = (Math.atan2(ny - y, nx - x) * 180) / Math.PI;
    return svg('path', {
      class: 'arrow',
      d: 'M-6 -5L6 0L-6 5z',
      transform: `translate(${x.toFixed(1)} ${y.toFixed(1)}) rotate(${turn.toFixed(1)})`,
    });
  }
}

// One figure of the page: heading, plot, legend, caption, and the table behind it.
import { el } from '../dom';
import { later } from '../later';
import type { Store, Theme } from '../state';
import { align, extent } from './align';
import { makeLegend, type Legend } from './legend';
import { onKey, pointAt, pointedAt, showCursor } from './link';
import { makePlot, scalesOf, type Plot } from './plot';
import type { FigureSpec } from './spec';
import { drawStatic } from './static';
import { tableOf } from './table_of';
import { tableTools } from './table';

/** What a figure remembers when it is made again for other units or another run. */
export interface Memory {
  zoom: [number, number] | null;
  hidden: Set<number>;
  open: boolean;
}

const KEYS = 'Arrow keys move the cursor, plus and minus zoom, 0 shows all.';

/** In words what the curves do: for who cannot see them. */
function describe(spec: FigureSpec, store: Store): string {
  const { yScale } = scalesOf(spec, store.get('units'));
  const parts = spec.curves
    .filter((curve) => !curve.quiet)
    .map((curve) => {
      const found = extent(curve.y);
      if (!found) return `${curve.label}: nothing known`;
      const [least, largest] = found.map((value) => (value * yScale.factor).toPrecision(4));
      return `${curve.label}: from ${least} to ${largest} ${yScale.symbol}`;
    });
  return `${spec.title}. ${parts.join('; ')}. ${KEYS}`;
}

export class Figure {
  readonly element: HTMLElement;
  private readonly root = el('div', { class: 'plot' });
  private readonly frame: HTMLElement;
  private readonly paper = el('div', { class: 'on-paper' });
  private readonly said = el('p', { class: 'offscreen', role: 'status' });
  private readonly legendRoot = el('div');
  private readonly ends: (() => void)[] = [];
  private plot: Plot | null = null;
  /** Whether its turn to be drawn has come. */
  private wanted = false;
  private legend: Legend | null = null;

  constructor(
    readonly spec: FigureSpec,
    private readonly store: Store,
    private readonly memory: Memory,
  ) {
    this.frame = el(
      'div',
      {
        class: 'frame',
        tabindex: 0,
        role: 'group',
        'aria-roledescription': 'figure',
        'aria-label': describe(spec, store),
      },
      this.root,
    );
    this.frame.addEventListener('keydown', (event) => this.key(event));
    const table = (): ReturnType<typeof tableOf> => tableOf(spec, store.get('units'));
    const tools = tableTools(table, spec.title, memory.open, (open) => (memory.open = open));
    const caption = el('figcaption', {}, el('p', { class: 'caption' }, spec.caption), ...tools);
    this.element = el(
      'figure',
      { id: `figure-${spec.id}`, class: 'figure' },
      el('h3', {}, spec.title),
      this.legendRoot,
      this.frame,
      this.paper,
      this.said,
      caption,
    );
    for (const key of ['place', 'time'] as const) {
      this.ends.push(store.subscribe(key, (_, source) => source !== this && this.follow()));
    }
    const sizes = new ResizeObserver(() => this.resize());
    sizes.observe(this.frame);
    const draw = (): void => {
      this.wanted = true;
      this.resize();
    };
    this.ends.push(() => sizes.disconnect(), later(this.element, draw));
    this.drawLegend(store.get('theme'));
  }

  dispose(): void {
    for (const end of this.ends) end();
    this.plot?.chart.destroy();
    this.plot = null;
  }

  /** Draws for print, in the colours for paper; the width of paper is not that of the screen. */
  print(on: boolean): void {
    const { spec, store, memory } = this;
    this.drawLegend(on ? 'light' : store.get('theme'));
    this.paper.replaceChildren(...(on ? [drawStatic(spec, store.get('units'), memory.zoom, memory.hidden)] : []));
  }

  private width(): number {
    return Math.max(240, Math.floor(this.frame.clientWidth) - 2);
  }

  private resize(): void {
    const height = this.spec.height ?? (this.width() < 560 ? 220 : 280);
    if (this.frame.clientWidth === 0) return;
    this.root.style.minHeight = `${height}px`;
    if (!this.wanted) return;
    if (this.plot && this.plot.chart.width === this.width()) return;
    if (this.plot) this.plot.chart.setSize({ width: this.width(), height });
    else this.draw(height);
    this.follow();
  }

  private draw(height: number): void {
    const { spec, store, memory } = this;
    this.plot?.chart.destroy();
    this.plot = makePlot(this.root, spec, {
      width: this.width(),
      height,
      theme: store.get('theme'),
      units: store.get('units'),
      hidden: memory.hidden,
      zoom: memory.zoom,
      onCursor: (x) => this.point(x),
      onZoom: (range) => this.remember(range),
    });
    this.drawLegend(store.get('theme'));
  }

  private drawLegend(theme: Theme): void {
    const { spec, store, memory } = this;
    const units = store.get('units');
    const aligned = this.plot?.aligned ?? align(spec.curves);
    this.legend = makeLegend(spec, aligned, scalesOf(spec, units).yScale, {
      theme,
      units,
      hidden: memory.hidden,
      onToggle: (index) => this.toggle(index),
    });
    this.legendRoot.replaceChildren(this.legend.element);
  }

  private toggle(index: number): void {
    const { hidden } = this.memory;
    if (!hidden.delete(index)) hidden.add(index);
    if (this.plot) this.draw(this.plot.chart.height);
    const buttons = this.legendRoot.querySelectorAll<HTMLButtonElement>('button');
    const shown = this.spec.curves.map((_, i) => i).filter((i) => !this.spec.curves[i]?.quiet);
    buttons[shown.indexOf(index)]?.focus();
    this.follow();
  }

  private remember(range: [number, number]): void {
    const reach = this.plot?.reach ?? range;
    const slack = (reach[1] - reach[0]) * 1e-6;
    const all = range[0] <= reach[0] + slack && range[1] >= reach[1] - slack;
    this.memory.zoom = all ? null : range;
    this.element.classList.toggle('zoomed', !all);
  }

  private point(x: number | null): void {
    this.legend?.update(x ?? pointedAt(this.spec, this.store));
    pointAt(this.spec, this.store, x, this);
  }

  private follow(): void {
    const x = pointedAt(this.spec, this.store);
    if (this.plot) showCursor(this.plot, x);
    this.legend?.update(x);
  }

  private key(event: KeyboardEvent): void {
    const { plot, spec, store } = this;
    if (!plot || event.target !== this.frame) return;
    const { factor } = plot.xScale;
    onKey(event, {
      reach: () => plot.reach,
      view: () => this.memory.zoom ?? plot.reach,
      cursor: () => pointedAt(spec, store),
      move: (x) => {
        pointAt(spec, store, x, null);
        this.said.textContent = this.legend?.sentence() ?? '';
      },
      zoom: ([from, to]) => {
        plot.chart.setScale('x', { min: from * factor, max: to * factor });
        this.follow();
      },
    });
  }
}

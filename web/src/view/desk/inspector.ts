// Figures over time of what was picked: a roller's load, or the chain's field at a place.
import uPlot from 'uplot';
import { button, el } from '../../dom';
import type { Theme } from '../../state';

export interface Picked {
  title: string;
  /** Lines of words under the title. */
  facts: string[];
  label: string;
  time: ArrayLike<number>;
  /** Values in the units that are shown; NaN where there is none. */
  values: ArrayLike<number>;
  /** A level to compare with, in the same units. */
  limit?: { label: string; value: number } | undefined;
}

const HEIGHT = 116;
const FONT = '11px system-ui';
const INK: Record<Theme, { text: string; grid: string; line: string; limit: string }> = {
  light: { text: '#3b4650', grid: '#d9dfe5', line: '#1f6f8b', limit: '#c2410c' },
  dark: { text: '#c3ccd5', grid: '#2d3742', line: '#4fb3d4', limit: '#f08c4a' },
};

export class Inspector {
  readonly root = el('section', { class: 'view-inspector', 'aria-label': 'Picked in the picture', hidden: true });
  private plot: uPlot | null = null;
  private time = NaN;

  constructor(
    private readonly seek: (time: number) => void,
    private readonly close: () => void,
  ) {}

  show(picked: Picked | null, theme: Theme): void {
    this.plot?.destroy();
    this.plot = null;
    this.root.hidden = !picked;
    if (!picked) return;
    const figure = el('div', { class: 'view-inspector-figure' });
    this.root.replaceChildren(
      el(
        'header',
        {},
        el('strong', {}, el('bdi', {}, picked.title.slice(0, 80))),
        button('\u00d7', this.close, { 'aria-label': 'Close', title: 'Close (Esc)' }),
      ),
      el('p', {}, picked.facts.join(' \u00b7 ')),
      el('p', { class: 'view-inspector-label' }, `${picked.label}, over time, s`),
      figure,
    );
    const known = Array.from(picked.values).some((value) => Number.isFinite(value));
    if (!known) figure.append(el('p', {}, 'No figures over time in these data.'));
    else this.plot = this.draw(figure, picked, theme);
  }

  private draw(figure: HTMLElement, picked: Picked, theme: Theme): uPlot {
    const ink = INK[theme];
    const axis = {
      stroke: ink.text,
      grid: { stroke: ink.grid, width: 1 },
      ticks: { stroke: ink.grid, width: 1 },
      font: FONT,
    };
    const values = Array.from(picked.values, (value) => (Number.isFinite(value) ? value : null));
    const data: uPlot.AlignedData = [Array.from(picked.time), values];
    const series: uPlot.Series[] = [{}, { label: picked.label, stroke: ink.line, width: 1.5, points: { show: false } }];
    if (picked.limit) {
      (data as unknown[]).push(values.map(() => picked.limit?.value ?? null));
      series.push({ label: picked.limit.label, stroke: ink.limit, width: 1, dash: [6, 4], points: { show: false } });
    }
    const plot = new uPlot(
      {
        width: Math.max(200, figure.clientWidth),
        height: HEIGHT,
        legend: { show: false },
        cursor: { drag: { x: false, y: false }, y: false },
        scales: { x: { time: false } },
        axes: [
          { ...axis, size: 20, gap: 2 },
          { ...axis, size: 46 },
        ],
        series,
        hooks: { draw: [(u): void => this.line(u, ink.limit)] },
      },
      data,
      figure,
    );
    plot.over.addEventListener('click', (event) => this.seek(plot.posToVal(event.offsetX, 'x')));
    return plot;
  }

  /** The time that is shown, as a line. */
  private line(u: uPlot, colour: string): void {
    if (!Number.isFinite(this.time)) return;
    const x = u.valToPos(this.time, 'x', true);
    u.ctx.save();
    u.ctx.strokeStyle = colour;
    u.ctx.beginPath();
    u.ctx.moveTo(x, u.bbox.top);
    u.ctx.lineTo(x, u.bbox.top + u.bbox.height);
    u.ctx.stroke();
    u.ctx.restore();
  }

  at(time: number): void {
    this.time = time;
    this.plot?.redraw(false, false);
  }

  dispose(): void {
    this.plot?.destroy();
  }
}

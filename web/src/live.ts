// A run while it is computed: the pull over time, and the view in three dimensions, both of what there is so far.
import type { ReportData } from './data';
import { withoutRoute } from './data';
import { el } from './dom';
import { Figure, type Memory } from './figure/figure';
import { Store, type Theme, type UnitSystem } from './state';
import { Frames } from './view/states/frames';
import { mountView } from './view/view';

/** A moment of the run: SI units, the segments from the tail. */
export interface Moment {
  time: number;
  /** At the winch; the largest anywhere; what theory expects of it; not finite: not known. */
  force: number;
  most: number;
  reference: number;
  position: Float32Array;
  tension: Float32Array;
}

export interface Live {
  add(moment: Moment): void;
}

/** Moments, and numbers in all of them, that are kept: where there are more every second moment goes. */
const MOMENTS = 600;
const NUMBERS = 4e6;
/** Share of the time that drawing may take: the reader has the rest. */
const SHARE = 0.25;
/** Time between two drawings of the figure, ms. */
const FIGURE_MS = 1000;
const STEPS = { position: { components: 3, unit: 'm', step: 1e-3 }, tension: { components: 1, unit: 'N', step: 1 } };

const known = (value: number): number | null => (Number.isFinite(value) ? value : null);

/** One field of all moments, as the view has it. */
class Growing {
  q = new Int32Array(0);
  constructor(
    readonly name: 'position' | 'tension',
    private readonly row: number,
  ) {}

  /** Row k becomes these values. */
  put(k: number, values: Float32Array): void {
    if ((k + 1) * this.row > this.q.length) {
      const more = new Int32Array(2 * (k + 1) * this.row);
      more.set(this.q);
      this.q = more;
    }
    const { step } = STEPS[this.name];
    const start = k * this.row;
    for (let i = 0; i < this.row; i++) this.q[start + i] = Math.round(values[i]! / step);
  }

  /** Row k takes the place of row `to`. */
  move(k: number, to: number): void {
    this.q.copyWithin(to * this.row, k * this.row, (k + 1) * this.row);
  }
}

export function live(root: HTMLElement, data: ReportData, units: UnitSystem, theme: Theme): Live {
  const run = data.runs[0];
  if (!run) throw new Error('There is no run.');
  withoutRoute(run);
  const segments = run.chain?.segments ?? 0;
  // what has been seen is no file: the fields come one by one
  run.states = { frames: 0, segments, time_s: [], head_at_m: [], fields: STEPS, packed: { position: '', tension: '' } };
  document.documentElement.dataset['theme'] = theme;
  const store = new Store({ place: null, time: null, units, theme, run: 0, roller: null });
  const viewRoot = el('div', { class: 'view' });
  const figureRoot = el('div', { class: 'live-figure' });
  root.replaceChildren(figureRoot, viewRoot);
  const view = mountView(viewRoot, run, store);
  const memory: Memory = { zoom: null, hidden: new Set(), open: false };
  let moments: Omit<Moment, 'position' | 'tension'>[] = [];
  const fields = [new Growing('position', 3 * segments), new Growing('tension', segments)];
  const most = Math.max(20, Math.min(MOMENTS, Math.floor(NUMBERS / Math.max(1, 4 * segments))));
  let every = 1; // of the moments that come one is kept
  let count = 0;
  let figure: Figure | null = null;
  let drawn = -Infinity;

  function draw(): void {
    const x = moments.map((one) => one.time);
    const curve = (
      label: string,
      role: 'simulated' | 'second' | 'theory',
      y: (one: Omit<Moment, 'position' | 'tension'>) => number,
    ) => ({
      label,
      role,
      x,
      y: moments.map((one) => known(y(one))),
    });
    const before = figure;
    before?.element.removeAttribute('id');
    figure = new Figure(
      {
        id: 'live',
        title: 'Force at the winch so far',
        caption: 'Forces of the run that is being computed, and what theory expects.',
        along: 'time',
        xLabel: 'time',
        yLabel: 'force',
        yUnit: 'N',
        fromZero: true,
        curves: [
          curve('winch', 'simulated', (one) => one.force),
          curve('largest tension anywhere', 'second', (one) => one.most),
          curve('expected by theory', 'theory', (one) => one.reference),
        ].filter((one) => one.y.some((value) => value !== null)),
      },
      store,
      memory,
    );
    // what stood there stays until the next one is drawn over it
    const { element } = figure;
    figureRoot.append(element);
    const settle = (): void => {
      if (!element.querySelector('canvas')) return void requestAnimationFrame(settle);
      before?.dispose();
      figureRoot.replaceChildren(element);
    };
    settle();
  }

  /** Shows all that there is; the next time comes when so much time has passed that the reader was not in its way. */
  let rests = -Infinity;
  let shows = false;
  function show(): void {
    const begun = performance.now();
    if (shows || begun < rests || segments === 0) return;
    shows = true;
    const frames = new Frames(
      moments.map((one) => one.time),
      segments,
    );
    for (const { name, q } of fields) {
      const meta = STEPS[name];
      frames.fields.set(name, { meta, q: q.subarray(0, moments.length * segments * meta.components) });
    }
    view.viewer.grown(frames);
    requestAnimationFrame(() =>
      setTimeout(() => {
        shows = false;
        const now = performance.now();
        rests = now + (now - begun) * (1 / SHARE - 1);
      }),
    );
  }

  function keep({ position, tension, ...one }: Moment): void {
    const last = moments[moments.length - 1];
    if (last && one.time < last.time) moments = []; // a finer pass begins
    if (last && one.time === last.time) moments.pop();
    if (count++ % every !== 0 || position.length !== 3 * segments) return;
    fields.forEach((field) => field.put(moments.length, field.name === 'position' ? position : tension));
    moments.push(one);
    if (moments.length <= most) return;
    moments = moments.filter((_, k) => k % 2 === 0);
    for (const field of fields) moments.forEach((_, k) => field.move(2 * k, k));
    every *= 2;
  }

  return {
    add(moment) {
      keep(moment);
      show();
      const now = performance.now();
      if (now - drawn < FIGURE_MS || figureRoot.children.length > 1 || figureRoot.contains(document.activeElement))
        return;
      drawn = now;
      draw();
    },
  };
}

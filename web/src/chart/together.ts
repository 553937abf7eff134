// Figures in which each run is one curve.
import type { RunData, Value } from '../data';
import { extent } from '../figure/align';
import { ORDER } from '../figure/palette';
import type { Curve, FigureSpec, Role } from '../figure/spec';
import { known, numbers } from '../run';
import { tensionFigure } from './along';

/** Names of the runs, the same for none of them. */
export function labels(runs: RunData[]): string[] {
  const seen = new Map<string, number>();
  return runs.map((run) => {
    const label = run.label || run.summary.title || 'run';
    const count = (seen.get(label) ?? 0) + 1;
    seen.set(label, count);
    return count === 1 ? label : `${label} (${count})`;
  });
}

function perRun(runs: RunData[], pick: (run: RunData) => { x: Value[]; y: Value[] } | null): Curve[] {
  const names = labels(runs);
  return runs.flatMap((run, i): Curve[] => {
    const found = pick(run);
    return found && known(found.y) ? [{ label: names[i] ?? '', role: ORDER[i] as Role, ...found }] : [];
  });
}

const meanTension = (run: RunData): { x: Value[]; y: Value[] } | null => {
  const curve = tensionFigure(run)?.curves.find(({ role }) => role === 'simulated');
  return curve ? { x: curve.x, y: curve.y } : null;
};

const pressure = (run: RunData): { x: Value[]; y: Value[] } | null => {
  const place = run.envelope?.place;
  return place?.sidewall_max_N_per_m ? { x: place.s_m, y: place.sidewall_max_N_per_m } : null;
};

const winchForce = (run: RunData): { x: Value[]; y: Value[] } | null => {
  const [x, y] = [numbers(run.series, 'time_s'), numbers(run.series, 'winch_force_N')];
  return x && y ? { x, y } : null;
};

const overHead = (run: RunData): { x: Value[]; y: Value[] } | null => {
  const [x, y] = [numbers(run.series, 'head_at_m'), numbers(run.series, 'winch_force_N')];
  const range = x ? extent(x) : null;
  return x && y && range && range[1] - range[0] > 0.5 ? { x, y } : null;
};

/** Tension, sidewall pressure and force of all runs together. */
export function togetherFigures(runs: RunData[]): FigureSpec[] {
  const figures: FigureSpec[] = [
    {
      id: 'together-tension',
      title: 'Tension along the route, all runs',
      caption: 'Steady means of the simulation; of a run without them the mean of the run.',
      along: 'place',
      xLabel: 'place along the route',
      yLabel: 'tension',
      yUnit: 'N',
      curves: perRun(runs, meanTension),
    },
    {
      id: 'together-sidewall',
      title: 'Sidewall pressure along the route, all runs',
      caption: 'The largest of each run.',
      along: 'place',
      xLabel: 'place along the route',
      yLabel: 'sidewall pressure',
      yUnit: 'N/m',
      curves: perRun(runs, pressure),
    },
    {
      id: 'together-force',
      title: 'Force at the winch over time, all runs',
      caption: 'As simulated.',
      along: 'time',
      xLabel: 'time',
      yLabel: 'force',
      yUnit: 'N',
      curves: perRun(runs, winchForce),
    },
    {
      id: 'together-head',
      title: 'Force at the winch over the place of the cable’s head, all runs',
      caption: 'As simulated, of the runs in which the head moves along the route.',
      along: 'place',
      xLabel: 'place of the cable’s head along the route',
      yLabel: 'force',
      yUnit: 'N',
      curves: perRun(runs, overHead),
    },
  ];
  return figures.filter((figure) => figure.curves.length > 1);
}

// Figures over time, and the winch's force over the place of the cable's head.
import type { RunData, Value } from '../data';
import { extent } from '../figure/align';
import { ORDER } from '../figure/palette';
import type { Curve, FigureSpec, Role } from '../figure/spec';
import { known, levels, marks, numbers, steadyWindow } from '../run';
import type { Unit } from '../units';

export interface Column {
  name: string;
  label: string;
  role: Role;
}

/** A figure over time of those columns of the series that are there; null if none is. */
export function timeFigure(
  run: RunData,
  id: string,
  title: string,
  caption: string,
  yLabel: string,
  yUnit: Unit,
  columns: Column[],
): FigureSpec | null {
  const x = numbers(run.series, 'time_s');
  if (!known(x)) return null;
  const curves = columns.flatMap(({ name, label, role }): Curve[] => {
    const y = numbers(run.series, name);
    return known(y) ? [{ label, role, x, y }] : [];
  });
  if (curves.length === 0) return null;
  const window = steadyWindow(run);
  const events = marks(run);
  const numbered = events.length > 0 ? ' Numbers: see Events.' : '';
  return {
    id,
    title,
    caption: caption + numbered,
    along: 'time',
    xLabel: 'time',
    yLabel,
    yUnit,
    curves,
    events,
    ...(window ? { window } : {}),
  };
}

export function forceFigure(run: RunData): FigureSpec | null {
  const figure = timeFigure(
    run,
    'force',
    'Force at the winch over time',
    'Forces of the run, and what the theory expects.',
    'force',
    'N',
    [
      { name: 'winch_force_N', label: 'winch', role: 'simulated' },
      { name: 'max_tension_N', label: 'largest tension anywhere', role: 'second' },
      { name: 'tail_tension_N', label: 'tail', role: 'third' },
      { name: 'reference_N', label: 'winch by the reference theory', role: 'theory' },
    ],
  );
  return figure && { ...figure, levels: levels(run, 'pull') };
}

/** Over the head's place, only where it moves along the route. */
export function headFigure(run: RunData): FigureSpec | null {
  const head = numbers(run.series, 'head_at_m');
  const time = numbers(run.series, 'time_s');
  const range = known(head) ? extent(head) : null;
  if (!range || range[1] - range[0] < 0.5 || !head || !time) return null;
  const order = head.map((_, i) => i).filter((i) => head[i] !== null);
  order.sort((a, b) => (head[a] as number) - (head[b] as number));
  const pick = (values: Value[]): Value[] => order.map((i) => values[i] ?? null);
  const x = pick(head);
  const curves: Curve[] = [];
  const add = (name: string, label: string, role: Role): void => {
    const y = numbers(run.series, name);
    if (known(y)) curves.push({ label, role, x, y: pick(y) });
  };
  add('winch_force_N', 'simulated', 'simulated');
  add('reference_N', 'reference theory', 'theory');
  const stretches = run.summary.pull_by_position ?? [];
  if (stretches.length > 0) {
    const at = (key: string): Value[] => stretches.map((stretch) => stretch[key] ?? null);
    curves.push({
      label: 'simulated, means of stretches',
      role: 'second',
      points: true,
      x: at('head_m'),
      y: at('pull_N'),
    });
  }
  if (curves.length === 0) return null;
  return {
    id: 'head',
    title: 'Force at the winch over the place of the cable’s head',
    caption:
      'How the pull grows while the cable comes in: what the crew sees at the winch when the head is at a place.',
    along: 'head',
    xLabel: 'place of the cable’s head along the route',
    yLabel: 'force',
    yUnit: 'N',
    curves,
    levels: levels(run, 'pull'),
    clock: { time, head },
  };
}

export function speedFigure(run: RunData): FigureSpec | null {
  const watched = Object.keys(run.series ?? {}).filter((name) => /^speed_\d+_m_per_s$/.test(name));
  const shown = watched.slice(0, ORDER.length);
  const more = watched.length > shown.length ? ` The first ${shown.length} of ${watched.length} watched segments.` : '';
  return timeFigure(
    run,
    'speed',
    'Speeds over time',
    `Segments are numbered from the tail, 0.${more}`,
    'speed',
    'm/s',
    [
      { name: 'winch_speed_m_per_s', label: 'winch', role: 'theory' },
      ...shown.map((name, i) => ({ name, label: `segment ${name.split('_')[1]}`, role: ORDER[i] as Role })),
    ],
  );
}

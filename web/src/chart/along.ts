// Figures along the route: tension, sidewall pressure, curvature, profile, loads of the rollers.
import type { RunData, Value } from '../data';
import { valueAt } from '../figure/align';
import type { Curve, FigureSpec, Role } from '../figure/spec';
import { known, levels, limitNamed, numbers } from '../run';

type Place = Pick<FigureSpec, 'along' | 'xLabel'>;
const ALONG: Place = { along: 'place', xLabel: 'place along the route' };

/** Places ascending, and a column in that order. */
function sorted(x: Value[], y: Value[]): { x: Value[]; y: Value[] } {
  const order = x.map((_, i) => i).filter((i) => x[i] !== null);
  order.sort((a, b) => (x[a] as number) - (x[b] as number));
  return { x: order.map((i) => x[i] ?? null), y: order.map((i) => y[i] ?? null) };
}

/** Whether two columns differ anywhere by more than a share of what they are. */
function differ(a: Value[], b: Value[], share: number): boolean {
  return a.some((value, i) => Math.abs((value ?? NaN) - (b[i] ?? NaN)) > share * Math.abs(value ?? 0));
}

function theoryCurves(run: RunData): Curve[] {
  const theory = run.theory_along;
  const stations = numbers(run.stations, 's_m') ?? [];
  const curves: Curve[] = [];
  const add = (label: string, role: Role, along: Value[] | undefined, column: string | null): void => {
    const at = column ? numbers(run.stations, column) : null;
    if (theory && known(along)) curves.push({ label, role, ...sorted(theory.s_m, along) });
    else if (known(at)) curves.push({ label, role, ...sorted(stations, at) });
  };
  const forward = theory?.forward_N;
  const ofRun = theory && known(theory.run_N) ? theory.run_N : undefined;
  add('reference theory', 'theory', ofRun ?? forward, 'reference_N');
  if (ofRun && known(forward) && differ(ofRun, forward, 0.005)) {
    add('theory, the whole route full of cable', 'third', forward, null);
  }
  add('theory, pulled the other way', 'backward', theory?.backward_N, null);
  add('piece formulas (eq. 3-10)', 'paper', theory?.paper_N, 'paper_N');
  return curves;
}

/** Tension along the route: simulated, by both theories, and what is allowed. */
export function tensionFigure(run: RunData): FigureSpec | null {
  const place = run.envelope?.place;
  const stations = numbers(run.stations, 's_m') ?? [];
  const curves: Curve[] = [];
  let band: FigureSpec['band'];
  if (place && known(place.tension_min_N) && known(place.tension_max_N)) {
    curves.push({ label: 'simulated, least', role: 'envelope', x: place.s_m, y: place.tension_min_N, quiet: true });
    curves.push({ label: 'simulated, largest', role: 'envelope', x: place.s_m, y: place.tension_max_N, quiet: true });
    band = { low: 0, high: 1, label: 'simulated, least to largest of the run' };
  }
  const mean = numbers(run.stations, 'mean_N');
  if (known(mean)) {
    curves.push({ label: 'simulated, steady mean', role: 'simulated', ...sorted(stations, mean) });
  } else if (place && known(place.tension_mean_N)) {
    curves.push({ label: 'simulated, mean of the run', role: 'simulated', x: place.s_m, y: place.tension_mean_N });
  }
  const peak = numbers(run.stations, 'peak_N');
  if (!band && known(peak)) {
    curves.push({ label: 'simulated, peak of the run', role: 'peak', ...sorted(stations, peak) });
  }
  curves.push(...theoryCurves(run));
  if (curves.length === 0) return null;
  const where = limitNamed(run, 'pull')?.where;
  return {
    id: 'tension',
    title: 'Tension along the route',
    caption:
      'Tension of the cable that passes a place. The theory for the other direction is of the whole route full of cable.' +
      (where ? ` The largest was at ${where}.` : ''),
    ...ALONG,
    yLabel: 'tension',
    yUnit: 'N',
    curves,
    levels: levels(run, 'pull'),
    ...(band ? { band } : {}),
  };
}

/** What a tension below 0 pushes with. */
const pushOf = (y: Value[]): Value[] => y.map((value) => (value === null ? null : Math.max(0, -value)));

/** Push along the route, of cables that a machine pushes: beside the load at which they leave their straight line. */
export function pushFigure(run: RunData): FigureSpec | null {
  const buckling = limitNamed(run, 'buckling');
  const tension = buckling?.value ? tensionFigure(run) : null;
  if (!tension) return null;
  const shown = tension.curves.filter((curve) => ['envelope', 'simulated', 'theory'].includes(curve.role));
  const curves = shown
    .filter((curve) => curve.label !== 'simulated, largest')
    .map((curve) => ({
      ...curve,
      y: pushOf(curve.y),
      label: curve.label.replace('least', 'largest of the run'),
      quiet: false,
    }));
  if (!curves.some((curve) => curve.y.some((value) => (value ?? 0) > 0))) return null;
  return {
    id: 'push',
    title: 'Push along the route',
    caption:
      'What a machine pushes the cable with, where its tension is below 0. Beyond the allowed push it snakes or coils in a duct, or bows between carriers and guides.' +
      (buckling?.where ? ` It is nearest to that at ${buckling.where}.` : ''),
    ...ALONG,
    yLabel: 'push',
    yUnit: 'N',
    curves,
    levels: levels(run, 'buckling', 'push'),
  };
}

/** T/R of the reference theory, of the whole route full of cable. */
function theoryPressure(run: RunData): Curve | null {
  const theory = run.theory_along;
  if (!theory || !known(theory.forward_sidewall_N_per_m)) return null;
  return { label: 'reference theory, T/R', role: 'theory', x: theory.s_m, y: theory.forward_sidewall_N_per_m };
}

/** Curvature of the route, from where it stands most densely. */
function routeCurvature(run: RunData): Curve | null {
  const { theory_along: theory, geometry } = run;
  const from = theory && known(theory.curvature_per_m) ? theory : geometry?.route;
  if (!from?.curvature_per_m || !known(from.curvature_per_m)) return null;
  const y = from.curvature_per_m.map((value) => (value === null ? null : Math.abs(value)));
  return { label: 'route', role: 'theory', x: from.s_m, y };
}

export function sidewallFigure(run: RunData): FigureSpec | null {
  const place = run.envelope?.place;
  const curves: Curve[] = [];
  if (place && known(place.sidewall_max_N_per_m)) {
    curves.push({
      label: 'simulated, largest of the run',
      role: 'simulated',
      x: place.s_m,
      y: place.sidewall_max_N_per_m,
    });
  }
  const theory = theoryPressure(run);
  if (theory) curves.push(theory);
  if (curves.length === 0) return null;
  return {
    id: 'sidewall',
    title: 'Sidewall pressure along the route',
    caption: 'Force per length with which the cable presses sideways.',
    ...ALONG,
    yLabel: 'sidewall pressure',
    yUnit: 'N/m',
    curves,
    levels: levels(run, 'sidewall'),
  };
}

export function curvatureFigure(run: RunData): FigureSpec | null {
  const place = run.envelope?.place;
  if (!place || !known(place.curvature_max_per_m)) return null;
  const curves: Curve[] = [
    { label: 'cable, largest of the run', role: 'simulated', x: place.s_m, y: place.curvature_max_per_m },
  ];
  const route = routeCurvature(run);
  if (route) curves.push(route);
  const radius = limitNamed(run, 'bend_radius')?.limit;
  return {
    id: 'curvature',
    title: 'Curvature along the route',
    caption: 'One over the radius to which the cable is bent. The allowed curvature is one over the allowed radius.',
    ...ALONG,
    yLabel: 'curvature',
    yUnit: '1/m',
    curves,
    levels: radius ? [{ label: 'allowed', value: 1 / radius }] : [],
  };
}

/** Height over the place along the route, with what stands there. */
export function profileFigure(run: RunData): FigureSpec | null {
  const geometry = run.geometry;
  if (!geometry || geometry.route.s_m.length < 2) return null;
  const { s_m: s, position_m: position } = geometry.route;
  const height = position.map((point) => point[2]);
  const curves: Curve[] = [{ label: 'route', role: 'route', x: s, y: height }];
  const rollers = geometry.rollers.filter((roller) => roller.s_m !== null);
  if (rollers.length > 0) {
    curves.push({
      label: 'rollers',
      role: 'ground',
      points: true,
      x: rollers.map((r) => r.s_m),
      y: rollers.map((r) => r.position_m[2]),
    });
  }
  const machines = geometry.conveyors;
  if (machines.length > 0) {
    const x: Value[] = [];
    const y: Value[] = [];
    for (const { from_m: from, to_m: to } of machines) {
      x.push(from, to, to + 1e-6);
      y.push(valueAt(s, height, from), valueAt(s, height, to), null);
    }
    curves.push({ label: 'conveyors', role: 'second', x, y });
  }
  return {
    id: 'profile',
    title: 'Profile',
    caption: 'Height over the place along the route; the scales of the two axes differ.',
    ...ALONG,
    yLabel: 'height',
    yUnit: 'm',
    fromZero: false,
    span: 2,
    curves,
    height: 200,
  };
}

/** Loads of the rollers where they stand. */
export function rollerFigure(run: RunData): FigureSpec | null {
  const x = numbers(run.rollers, 's_m');
  if (!known(x)) return null;
  const curves: Curve[] = [];
  const add = (column: string, label: string, role: Role): void => {
    const y = numbers(run.rollers, column);
    if (known(y)) curves.push({ label, role, points: true, ...sorted(x, y) });
  };
  add('steady_N', 'steady mean', 'simulated');
  add('peak_N', 'peak of the run', 'second');
  if (curves.length === 0) return null;
  const ratings = new Set((numbers(run.rollers, 'rating_N') ?? []).filter((rating) => rating !== null));
  const one = ratings.size === 1 ? [...ratings][0] : null;
  return {
    id: 'rollers',
    title: 'Loads of the rollers along the route',
    caption: x.includes(null)
      ? 'Rollers that were placed by coordinates have no place along the route; the table below has all.'
      : 'Where each roller stands.',
    ...ALONG,
    yLabel: 'load',
    yUnit: 'N',
    curves,
    levels: one ? [{ label: 'rating', value: one }] : [],
  };
}

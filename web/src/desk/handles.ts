/** What can be dragged in plan and profile: each handle stands for one value of the text, and a drag is one splice of it. */
import { isMap, isScalar, isSeq, type Node } from 'yaml';
import { add, arcOf, dot, minus, RAD, type Spot } from './arc';
import type { Along, Piece } from './engine';
import { corners, planned } from './handles_plan';
import { between, changed, read, snapped, writtenAt } from './desk';
import { nodeAt, parsed, setValue, type Change, type Path } from './splice';
import { t } from './words';

export type { Spot } from './arc';
export type Kind =
  'length' | 'radius' | 'angle' | 'slope' | 'corner' | 'height' | 'roller' | 'pit' | 'machine' | 'conveyor';

export interface Handle {
  kind: Kind;
  view: 'plan' | 'profile';
  label: string;
  /** Where it stands: x and y, or place along the route and height, m. */
  at: Spot;
  s: number;
  /** Which way it is drawn beside its spot, with a line to it: handles of a small bend would lie on each other. */
  out?: Spot;
  /** Its value as it is written now. */
  value: string;
  /** The change that moves it to a spot. */
  move(text: string, to: Spot): Change | undefined;
  /** The change of one key press. */
  step(text: string, right: number, up: number): Change | undefined;
}

const MOST = 300;
/** A drag makes no bend tighter, m: cables do not bear it. */
export const LEAST_RADIUS = 0.5;
/** A value between its samples. */
export function sample(at: number[], values: (number | null)[], s: number): number {
  let low = 0;
  let high = at.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if ((at[middle] ?? 0) <= s) low = middle;
    else high = middle;
  }
  const [a, b] = [at[low] ?? 0, at[high] ?? 0];
  const share = b > a ? Math.min(1, Math.max(0, (s - a) / (b - a))) : 0;
  return (values[low] ?? NaN) * (1 - share) + (values[high] ?? NaN) * share;
}

export const spotAt = (along: Along, s: number): Spot => [
  sample(along.s_m, along.x_m, s),
  sample(along.s_m, along.y_m, s),
];

/** The place along the route that is nearest to a spot of the plan. */
export function nearest(along: Along, [x, y]: Spot): number {
  let best = 0;
  let least = Infinity;
  for (let i = 0; i + 1 < along.s_m.length; i++) {
    const a: Spot = [along.x_m[i] ?? 0, along.y_m[i] ?? 0];
    const way = minus([along.x_m[i + 1] ?? 0, along.y_m[i + 1] ?? 0], a);
    const size = dot(way, way);
    const share = size > 0 ? Math.min(1, Math.max(0, dot(minus([x, y], a), way) / size)) : 0;
    const away = minus(add(a, way, share), [x, y]);
    if (dot(away, away) < least) {
      least = dot(away, away);
      best = (along.s_m[i] ?? 0) + share * ((along.s_m[i + 1] ?? 0) - (along.s_m[i] ?? 0));
    }
  }
  return best;
}

/** A handle of one length or angle: `amount` is the value, SI or degrees, that a spot means; the drag goes by its change. */
export function single(
  one: Omit<Handle, 'move' | 'step' | 'value'> & { path: Path; unit: 'm' | 'deg'; amount(to: Spot): number },
  text: string,
  least: number,
  most: number,
): Handle | undefined {
  const value = writtenAt(text, one.path);
  const old = value === undefined ? undefined : read(value);
  if (value === undefined || !old) return undefined;
  const set = (now: string, next: number): Change | undefined => {
    if (!(next < 1e6)) return undefined;
    return setValue(now, one.path, snapped(value, Math.min(most, Math.max(least, next)), one.unit));
  };
  return {
    ...one,
    value,
    move: (now, to) => set(now, old.value + one.amount(to) - one.amount(one.at)),
    // from what is written by now: keys are faster than theory
    step: (now, right, up) =>
      set(
        now,
        (read(writtenAt(now, one.path) ?? '')?.value ?? old.value) +
          (right || up) * (one.unit === 'deg' ? 1 : old.unit === 'ft' ? 0.1524 : 0.1),
      ),
  };
}

/** A handle of coordinates that stand beside each other in one list, as [x, y, z]. */
function coordinates(
  kind: Kind,
  label: string,
  list: Path,
  view: 'plan' | 'profile',
  s: number,
  text: string,
): Handle | undefined {
  const which = view === 'plan' ? [0, 1] : [2];
  const nodes = which.map((i) => nodeAt(parsed(text), [...list, i]));
  const values = which.map((i) => writtenAt(text, [...list, i]));
  const old = values.map((value) => (value === undefined ? undefined : read(value)));
  if (nodes.some((node) => !node) || old.some((one) => !one)) return undefined;
  const now = old.map((one) => one?.value ?? 0);
  const set = (words: string, next: number[]): Change | undefined => {
    let after = words;
    for (const [k, i] of which.entries()) {
      const one = setValue(after, [...list, i], snapped(values[k] ?? '', next[k] ?? 0, 'm'));
      if (!one) return undefined;
      after = changed(after, one);
    }
    return between(words, after);
  };
  const at: Spot = view === 'plan' ? [now[0] ?? 0, now[1] ?? 0] : [s, now[0] ?? 0];
  return {
    kind,
    view,
    label,
    at,
    s,
    value: values.join(', '),
    move: (words, to) => set(words, view === 'plan' ? to : [to[1]]),
    step: (words, right, up) => {
      const [a = 0, b = 0] = which.map((k) => read(writtenAt(words, [...list, k]) ?? '')?.value ?? 0);
      return set(words, view === 'plan' ? [a + 0.1 * right, b + 0.1 * up] : [a + 0.1 * (right || up)]);
    },
  };
}

export type Found = (Handle | undefined)[];

/** Pieces end to end: the end of a straight is its length, the middle of a bend its radius, its end its angle. */
function pieces(text: string, along: Along): Found {
  const list = nodeAt(parsed(text), ['route', 'pieces']);
  if (!list || !isSeq(list)) return [];
  const found: Found = [];
  along.pieces.forEach((piece, p) => {
    const item = list.items[piece.listed - 1];
    if (piece.listed === 0 || !isMap(item) || along.pieces[p - 1]?.listed === piece.listed) return;
    const path: Path = ['route', 'pieces', piece.listed - 1];
    const name = piece.name || `${t('piece')} ${piece.listed}`;
    if (item.has('straight')) found.push(...straight(text, along, piece, path, name));
    else if (item.has('clothoid')) found.push(curved(text, along, piece, [...path, 'clothoid'], name, 'plan'));
    else if (item.has('parabola')) found.push(curved(text, along, piece, [...path, 'parabola'], name, 'profile'));
    else if (item.has('bend') && item.has('radius')) {
      const plane = writtenAt(text, [...path, 'plane']);
      if (plane === 'left' || plane === 'right') found.push(...level(text, along, p, path, name, plane));
      else if (plane === 'up' || plane === 'down') found.push(...upright(text, along, p, path, name, plane));
    }
  });
  return found;
}

function straight(text: string, along: Along, piece: Piece, path: Path, name: string): Found {
  const [tx, ty] = piece.tangent;
  const flat = Math.hypot(tx, ty);
  const end = piece.s_m + piece.length_m;
  const found: Found = [];
  if (flat > 0.1) {
    const begin: Spot = [piece.start[0], piece.start[1]];
    const way: Spot = [tx / (flat * flat), ty / (flat * flat)];
    found.push(
      single(
        {
          kind: 'length',
          view: 'plan',
          label: `${name}: ${t('length')}`,
          at: spotAt(along, end),
          s: end,
          path: [...path, 'straight'],
          unit: 'm',
          amount: (to) => dot(minus(to, begin), way),
        },
        text,
        0.1,
        1e6,
      ),
    );
  }
  const slope = writtenAt(text, [...path, 'slope']);
  const percent = /^([-+]?[\d.]+)\s*%$/.exec(slope ?? '');
  const degrees = /^([-+]?[\d.]+)\s*(?:deg|\u00b0)$/.exec(slope ?? '');
  if (slope !== undefined && (percent || degrees)) {
    const rise = (to: Spot): number => (to[1] - piece.start[2]) / Math.max(0.1, piece.length_m * flat);
    const now = Number((percent ?? degrees)?.[1]);
    const write = (value: number, step: number): string =>
      percent ? `${(Math.round(value / step) * step).toFixed(1).replace(/\.0$/, '')} %` : `${Math.round(value)} deg`;
    const of = (tangent: number): number => (percent ? 100 * tangent : Math.atan(tangent) / RAD);
    const at: Spot = [end, sample(along.s_m, along.z_m, end)];
    found.push({
      kind: 'slope',
      view: 'profile',
      label: `${name}: ${t('slope')}`,
      at,
      s: end,
      value: slope,
      move: (words, to) => setValue(words, [...path, 'slope'], write(now + of(rise(to)) - of(rise(at)), 0.5)),
      step: (words, right, up) => {
        const here = Number.parseFloat(writtenAt(words, [...path, 'slope']) ?? '') || 0;
        return setValue(words, [...path, 'slope'], write(here + (right || up) * (percent ? 0.5 : 1), 0.5));
      },
    });
  }
  return found;
}

/** Of a clothoid or a parabola: its length, where it ends. */
function curved(
  text: string,
  along: Along,
  piece: Piece,
  path: Path,
  name: string,
  view: Handle['view'],
): Handle | undefined {
  const end = Math.max(
    ...along.pieces.filter((one) => one.listed === piece.listed).map((one) => one.s_m + one.length_m),
  );
  const at: Spot = view === 'plan' ? spotAt(along, end) : [end, sample(along.s_m, along.z_m, end)];
  const way = minus(at, spotAt(along, end - piece.length_m / 10));
  const size = Math.hypot(...way);
  const amount = (to: Spot): number => (view === 'plan' ? dot(to, way) / size : to[0]);
  return single(
    { kind: 'length', view, label: `${name}: ${t('length')}`, at, s: end, path, unit: 'm', amount },
    text,
    0.1,
    1e6,
  );
}

/** Of a bend to the left or right: the radius in its middle, the angle on the straight behind it, which it turns. */
function level(text: string, along: Along, p: number, path: Path, name: string, plane: string): Found {
  const piece = along.pieces[p];
  if (!piece) return [];
  const flat = Math.hypot(piece.tangent[0], piece.tangent[1]);
  const angle = read(writtenAt(text, [...path, 'bend']) ?? '')?.value;
  const radius = read(writtenAt(text, [...path, 'radius']) ?? '')?.value;
  if (!(flat > 0.1) || !angle || !radius) return [];
  const begin: Spot = [piece.start[0], piece.start[1]];
  const ahead: Spot = [piece.tangent[0] / flat, piece.tangent[1] / flat];
  const side = plane === 'left' ? 1 : -1;
  const arc = arcOf(begin, ahead, side, radius, angle);
  const middle = piece.s_m + piece.length_m / 2;
  const next = along.pieces[p + 1];
  const end = piece.s_m + piece.length_m + (next?.kind === 'straight' ? next.length_m / 2 : 0);
  return [
    single(
      {
        kind: 'radius',
        view: 'plan',
        label: `${name}: ${t('radius')}`,
        at: arc.middle,
        out: arc.out,
        s: middle,
        path: [...path, 'radius'],
        unit: 'm',
        amount: arc.radiusAt,
      },
      text,
      LEAST_RADIUS,
      1e6,
    ),
    single(
      {
        kind: 'angle',
        view: 'plan',
        label: `${name}: ${t('angle')}`,
        at: spotAt(along, end),
        s: end,
        path: [...path, 'bend'],
        unit: 'deg',
        amount: arc.angleAt,
      },
      text,
      1,
      360,
    ),
  ];
}

/** Of a bend up or down: the radius in its middle; the angle where the straight behind it ends, which it lifts. */
function upright(text: string, along: Along, p: number, path: Path, name: string, plane: string): Found {
  const piece = along.pieces[p];
  const next = along.pieces[p + 1];
  const angle = read(writtenAt(text, [...path, 'bend']) ?? '')?.value;
  if (!piece || !angle) return [];
  const middle = piece.s_m + piece.length_m / 2;
  const found: Found = [
    single(
      {
        kind: 'radius',
        view: 'profile',
        label: `${name}: ${t('radius')}`,
        at: [middle, sample(along.s_m, along.z_m, middle)],
        s: middle,
        path: [...path, 'radius'],
        unit: 'm',
        amount: (to) => (to[0] - piece.s_m) / ((angle * RAD) / 2),
      },
      text,
      LEAST_RADIUS,
      1e6,
    ),
  ];
  if (next?.kind === 'straight') {
    const end = next.s_m + next.length_m;
    const flat = Math.hypot(next.tangent[0], next.tangent[1]);
    const side = plane === 'up' ? 1 : -1;
    found.push(
      single(
        {
          kind: 'angle',
          view: 'profile',
          label: `${name}: ${t('angle')}`,
          at: [end, sample(along.s_m, along.z_m, end)],
          s: end,
          path: [...path, 'bend'],
          unit: 'deg',
          amount: (to) => (side * (to[1] - next.start[2])) / (next.length_m * Math.max(flat, 0.2)) / RAD,
        },
        text,
        1,
        180,
      ),
    );
  }
  return found;
}

/** Corners by coordinates, and the radii by which they are rounded. */
function points(text: string, along: Along): Found {
  const list = nodeAt(parsed(text), ['route', 'points']);
  if (!list || !isSeq(list)) return [];
  const found: Found = [];
  list.items.forEach((_, i) => {
    const path: Path = ['route', 'points', i];
    const name = `${t('corner')} ${i + 1}`;
    const [x, y] = [0, 1].map((k) => read(writtenAt(text, [...path, k]) ?? '')?.value);
    if (x === undefined || y === undefined) return;
    const corner: Spot = [x, y];
    const s = nearest(along, corner);
    found.push(
      coordinates('corner', name, path, 'plan', s, text),
      coordinates('height', `${name}: ${t('height')}`, path, 'profile', s, text),
    );
    const own = writtenAt(text, [...path, 3]) !== undefined ? [...path, 3] : (['route', 'radius'] as Path);
    const bend = along.pieces.find((one) => one.kind === 'bend' && one.s_m <= s && s <= one.s_m + one.length_m);
    const radius = read(writtenAt(text, own) ?? '')?.value;
    if (!bend || !radius) return;
    const middle = bend.s_m + bend.length_m / 2;
    const at = spotAt(along, middle);
    const inside = minus(at, corner);
    const size = Math.hypot(...inside);
    if (size < 1e-6) return;
    found.push(
      single(
        {
          kind: 'radius',
          view: 'plan',
          label: `${name}: ${t('radius')}`,
          at,
          out: [inside[0] / size, inside[1] / size],
          s: middle,
          path: own,
          unit: 'm',
          amount: (to) => (dot(minus(to, corner), inside) / size) * (radius / size),
        },
        text,
        LEAST_RADIUS,
        1e6,
      ),
    );
  });
  return found;
}

/** What stands at a place along the route: it slides along. */
function stands(text: string, along: Along): Found {
  const document = parsed(text);
  const found: Found = [];
  const slide = (kind: Kind, label: string, path: Path): void => {
    const s = read(writtenAt(text, path) ?? '')?.value;
    if (s === undefined) return;
    const common = { kind, label, s, path, unit: 'm' as const };
    const length = along.s_m.at(-1) ?? 0;
    found.push(
      single({ ...common, view: 'plan', at: spotAt(along, s), amount: (to) => nearest(along, to) }, text, 0, length),
      single(
        { ...common, view: 'profile', at: [s, sample(along.s_m, along.z_m, s)], amount: (to) => to[0] },
        text,
        0,
        length,
      ),
    );
  };
  const each = (path: Path, what: (item: Node, path: Path, i: number) => void): void => {
    const node = nodeAt(document, path);
    if (isSeq(node)) (node.items as Node[]).forEach((item, i) => what(item, [...path, i], i));
  };
  each(['theory', 'pits'], (_, path, i) => slide('pit', `${t('pit')} ${i + 1}`, [...path, 'at']));
  each(['theory', 'machines'], (_, path, i) => slide('machine', `${t('machine')} ${i + 1}`, [...path, 'at']));
  each(['conveyors'], (_, path, i) => {
    slide('conveyor', `${t('conveyor')} ${i + 1}: ${t('from')}`, [...path, 'from']);
    slide('conveyor', `${t('conveyor')} ${i + 1}: ${t('to')}`, [...path, 'to']);
  });
  const row = (path: Path): void => {
    each([...path, 'at'], (item, one, i) => {
      if (isScalar(item)) slide('roller', `${t('roller')} ${i + 1}`, one);
    });
  };
  if (isMap(nodeAt(document, ['rollers', 'along']))) row(['rollers', 'along']);
  each(['rollers', 'along'], (_, path) => row(path));
  each(['rollers', 'list'], (_, path, i) => {
    const [x, y] = [0, 1].map((k) => read(writtenAt(text, [...path, 'centre', k]) ?? '')?.value);
    if (x === undefined || y === undefined) return;
    found.push(
      coordinates('roller', `${t('roller')} ${i + 1}`, [...path, 'centre'], 'plan', nearest(along, [x, y]), text),
    );
  });
  return found;
}

export function handles(text: string, along: Along): Handle[] {
  const all = [pieces, points, planned, corners, stands].flatMap((of) => of(text, along));
  return all.filter((one) => one !== undefined).slice(0, MOST);
}

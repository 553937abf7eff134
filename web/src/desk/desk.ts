/** What the views of the desk share: the text and how it is changed, theory of it, the place that is marked. */
import { digits, scaleOf, type Unit } from '../units';
import type { Along, Engine, Theory } from './engine';
import { nodeAt, parsed, type Change, type Path } from './splice';
import { isScalar } from 'yaml';

export interface Editing {
  text(): string;
  /** rows: the table has other rows then, and is made anew at once. */
  change(change: Change | Change[] | undefined, what: string, rows?: boolean): void;
}

export interface Desk extends Editing {
  engine(): Engine | undefined;
  us(): boolean;
  /** Of the text as it stands, or of the last that was a case. */
  theory(): Theory | undefined;
  along(): Along | undefined;
  place: Place;
  say(words: string): void;
}

/** The place along the route that is marked in all views, m; null: none. */
export class Place {
  at: number | null = null;
  private readonly listeners: ((at: number | null) => void)[] = [];

  mark(at: number | null): void {
    if (at === this.at) return;
    this.at = at;
    for (const one of this.listeners) one(at);
  }

  follow(listener: (at: number | null) => void): void {
    this.listeners.push(listener);
  }
}

/** Only the newest of many questions is answered: while one is under way, all but the last of the others are dropped. */
export function newest<A, B>(
  ask: (question: A) => Promise<B>,
  take: (answer: B | undefined) => void,
): (one: A) => void {
  let busy = false;
  let next: { one: A } | undefined;
  const go = async (one: A): Promise<void> => {
    busy = true;
    const answer = await ask(one).catch(() => undefined);
    busy = false;
    const following = next;
    next = undefined;
    if (following) void go(following.one);
    else take(answer);
  };
  return (one) => {
    if (busy) next = { one };
    else void go(one);
  };
}

/** From the best verdict to the worst. */
const RANKS = ['safe', 'safe_if', 'not_judged', 'not_trusted', 'not_safe'];

/** Of several chains that are pulled together the one with the worst verdict; '': the only one. */
export function worstChain(whole: Theory): { chain: string; one: Theory; chains: number } {
  const chains = Object.entries(whole.theory ?? { '': whole });
  const rank = (one: Theory): number => RANKS.indexOf(one.verdict_code);
  const [chain, one] = chains.reduce((worst, each) => (rank(each[1]) > rank(worst[1]) ? each : worst));
  return { chain, one, chains: chains.length };
}

/** A quantity as people read it; '–': not known. */
export function quantity(value: number | null | undefined, unit: Unit, us: boolean, significant = 4): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return '–';
  const { symbol, factor } = scaleOf(unit, us ? 'us' : 'si', value);
  return `${digits(value * factor, significant)}${symbol ? `\u00a0${symbol}` : ''}`;
}

/** What the text says at a path, as it is written. */
export function writtenAt(text: string, path: Path): string | undefined {
  const node = nodeAt(parsed(text), path);
  return node && isScalar(node) ? (node.source ?? '') : undefined;
}

const UNITS: Record<string, number> = {
  mm: 1e-3,
  cm: 1e-2,
  m: 1,
  km: 1e3,
  in: 0.0254,
  ft: 0.3048,
  N: 1,
  kN: 1e3,
  MN: 1e6,
  lbf: 4.4482216152605,
  deg: 1,
  '\u00b0': 1,
  rad: 180 / Math.PI,
};

/** A written value in SI, angles in degrees, with its unit; undefined: not a number of a unit that is known here. */
export function read(value: string): { value: number; unit: string; factor: number } | undefined {
  const found = /^([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*([A-Za-z\u00b0]*)$/.exec(value.trim());
  const unit = found?.[2] ?? '';
  const factor = unit ? UNITS[unit] : 1;
  return found && factor ? { value: Number(found[1]) * factor, unit, factor } : undefined;
}

/** A number without the zeros at its end. */
export const plain = (value: number, places: number): string =>
  String(Number(value.toFixed(places))).replace(/^-0$/, '0');

/** A length or angle as it is written beside one that is there, in its unit, on a round value: 0.1 m, 0.5 ft, 1 degree. */
export function snapped(before: string, value: number, kind: 'm' | 'deg'): string {
  const old = read(before);
  const unit = old?.unit ? old.unit : kind;
  const factor = old?.unit ? old.factor : 1;
  const feet = unit === 'ft' || unit === 'in';
  const step = kind === 'deg' ? 1 : feet ? 0.1524 : 0.1;
  const round = Math.round(value / step) * step;
  return `${plain(round / factor, kind === 'deg' && unit === 'rad' ? 5 : factor > 1 && unit !== 'rad' ? 4 : 3)} ${unit}`;
}

/** One change that makes the text after out of that before: what both begin and end with stays. */
export function between(before: string, after: string): Change | undefined {
  if (before === after) return undefined;
  let from = 0;
  const most = Math.min(before.length, after.length);
  while (from < most && before[from] === after[from]) from++;
  let back = 0;
  while (back < most - from && before[before.length - 1 - back] === after[after.length - 1 - back]) back++;
  return { from, to: before.length - back, insert: after.slice(from, after.length - back) };
}

/** The text with a change in it. */
export const changed = (text: string, change: Change): string =>
  text.slice(0, change.from) + change.insert + text.slice(change.to);

/** Several changes, each of the text that the one before leaves, as one; undefined: one of them cannot be made. */
export function together(text: string, steps: ((text: string) => Change | undefined)[]): Change | undefined {
  let now = text;
  for (const step of steps) {
    const change = step(now);
    if (!change) return undefined;
    now = changed(now, change);
  }
  return between(text, now);
}

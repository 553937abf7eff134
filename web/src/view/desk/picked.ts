// What the inspector shows of a roller or a place.
import type { RunData } from '../../data';
import type { UnitSystem } from '../../state';
import { scaleOf, show } from '../../units';
import { Frames } from '../states/frames';
import type { Picked } from './inspector';
import type { Model } from '../states/model';
import type { Now } from '../states/now';
import { unpackField } from '../states/packed';
import { lengthText, type Quantity } from '../states/quantity';

const FORCE = 'force';

/** Forces on all rollers over time; null where the data have none. */
export async function rollerForces(run: RunData): Promise<Frames | null> {
  const meta = run.roller_force;
  const rollers = run.geometry?.rollers.length ?? 0;
  const time = run.states?.time_s ?? [];
  if (!meta || rollers === 0) return null;
  const frames = new Frames(time, rollers);
  frames.fields.set(FORCE, { meta, q: await unpackField(meta.packed, time.length, rollers, meta.components) });
  return frames;
}

/** A column of series.csv with the roller's load, where the case asked for it. */
function loadInSeries(run: RunData, name: string): { time: number[]; values: number[] } | null {
  const column = run.series?.[`load_${name}_N`];
  const time = run.series?.['time_s'];
  if (!Array.isArray(column) || !Array.isArray(time)) return null;
  return { time: time.map(Number), values: column.map((value) => (typeof value === 'number' ? value : NaN)) };
}

const scaled = (values: ArrayLike<number>, factor: number): Float64Array =>
  Float64Array.from(values, (value) => value * factor);

export function pickedRoller(model: Model, index: number, forces: Frames | null, system: UnitSystem): Picked | null {
  const roller = model.run.geometry?.rollers[index];
  if (!roller) return null;
  const series = loadInSeries(model.run, roller.name);
  const values = series?.values ?? forces?.history(FORCE, () => index) ?? [];
  const time = series?.time ?? forces?.time ?? [];
  const table = model.run.rollers;
  const row = table?.['name']?.indexOf(roller.name) ?? -1;
  const figure = (key: string): number | null => {
    const value = row >= 0 ? table?.[key]?.[row] : null;
    return typeof value === 'number' ? value : null;
  };
  const peak = figure('peak_N');
  const facts = [roller.s_m === null ? roller.kind : `${roller.kind} at ${lengthText(roller.s_m, system)}`];
  for (const [words, key] of [
    ['steady', 'steady_N'],
    ['peak', 'peak_N'],
  ] as const) {
    const value = figure(key);
    if (value !== null) facts.push(`${words} ${show(value, 'N', system, 3)}`);
  }
  if (roller.rating_N !== null) facts.push(`may carry ${show(roller.rating_N, 'N', system, 3)}`);
  const largest = Array.from(values).reduce((a, b) => (b > a ? b : a), peak ?? 0);
  const { symbol, factor } = scaleOf('N', system, largest);
  const limit =
    roller.rating_N !== null && roller.rating_N < 4 * largest
      ? { label: 'rating', value: roller.rating_N * factor }
      : undefined;
  return { title: roller.name, facts, label: `load, ${symbol}`, time, values: scaled(values, factor), limit };
}

/** Farther from a place than this, in lengths of a segment, there is no cable at it. */
const REACH = 1.5;

export function pickedPlace(model: Model, s: number, now: Now, quantity: Quantity, system: UnitSystem): Picked | null {
  if (!model.path || !model.chain) return null;
  const longest = model.chain.length_m.reduce((a, b) => Math.max(a, b), 0);
  const segments = now.segmentsAt(model.path.at(s), Math.max(1, REACH * longest));
  const raw = now.frames.history(quantity.field, (frame) => Math.max(0, segments[frame]!));
  const values = raw ? raw.map((value, frame) => (segments[frame]! < 0 ? NaN : value)) : [];
  const known = Array.from(values).filter((value) => Number.isFinite(value));
  const largest = known.reduce((a, b) => Math.max(a, b), -Infinity);
  const { symbol, factor } = scaleOf(quantity.unit, system, Math.max(Math.abs(largest), 0));
  const facts = known.length > 0 ? [] : ['nothing passes there'];
  if (known.length > 0) facts.push(`largest ${show(largest, quantity.unit, system, 3)}`);
  return {
    title: `Place ${lengthText(s, system)}`,
    facts,
    label: `${quantity.title.toLowerCase()}${symbol ? `, ${symbol}` : ''}`,
    time: now.frames.time,
    values: scaled(values, factor),
  };
}

// From which value to which the colours go, and where the legend has its ticks.
import type { Frames } from './frames';

export interface Scale {
  low: number;
  high: number;
  /** Largest value there is, if it is beyond `high`. */
  beyond: number | null;
}

const BINS = 2048;
/** Share of all values that the colours reach; the rest are single peaks that would hide everything else. */
const REACHED = 0.998;

/**
 * The colours' ends for a field: 0 or the smallest value, and the largest one, or the one that REACHED of all values stay below where the
 * largest is more than twice that. `skipped(item, frame)` leaves out what is not to count, as cable on the reel.
 */
export function scaleOf(
  frames: Frames,
  name: string,
  skipped: (item: number, frame: number) => boolean = () => false,
): Scale | null {
  const field = frames.fields.get(name);
  if (!field) return null;
  const { q, meta } = field;
  let least = Infinity;
  let largest = -Infinity;
  const each = (visit: (value: number) => void): void => {
    for (let frame = 0; frame < frames.count; frame++)
      for (let item = 0; item < frames.items; item++) if (!skipped(item, frame)) visit(q[frame * frames.items + item]!);
  };
  each((value) => {
    if (value < least) least = value;
    if (value > largest) largest = value;
  });
  if (least > largest) return null;
  const bins = new Uint32Array(BINS);
  let count = 0;
  const width = Math.max(1, largest - least) / (BINS - 1);
  each((value) => {
    bins[Math.floor((value - least) / width)]!++;
    count++;
  });
  let bin = 0;
  for (let sum = bins[0]!; sum < REACHED * count && bin < BINS - 1;) sum += bins[++bin]!;
  const usual = least + (bin + 1) * width;
  const clipped = largest > 0 && largest - least > 2 * (usual - least);
  const low = Math.min(0, least) * meta.step;
  const high = (clipped ? usual : largest) * meta.step;
  return { low, high: high > low ? high : low + meta.step, beyond: clipped ? largest * meta.step : null };
}

/** Round values between the ends, about `count` of them: 1, 2 or 5 times a power of ten apart. */
export function ticksOf(low: number, high: number, count: number): number[] {
  const rough = (high - low) / Math.max(1, count);
  if (!(rough > 0)) return [];
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5, 10].find((factor) => factor * power >= rough) ?? 10);
  const ticks: number[] = [];
  for (let i = Math.ceil(low / step - 1e-9) + 0; i * step <= high * (1 + 1e-12) + 1e-9 * step; i++)
    ticks.push(i * step);
  return ticks;
}

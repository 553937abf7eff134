// What is under the pointer: done on the screen, so that it agrees with what is drawn whatever the exaggeration.

/** Points on the screen: x and y in pixels, depth in front of the camera (negative behind it), one after the other. */
export interface Screen {
  x: Float32Array;
  y: Float32Array;
  depth: Float32Array;
}

export const screenOf = (n: number): Screen => ({
  x: new Float32Array(n),
  y: new Float32Array(n),
  depth: new Float32Array(n),
});

/**
 * Puts points (xyz one after the other) on a screen of width x height pixels; `clip` is the camera's projection times its view, by
 * columns.
 */
export function project(
  points: ArrayLike<number>,
  clip: ArrayLike<number>,
  width: number,
  height: number,
  out: Screen,
): void {
  const row = (r: number): [number, number, number, number] => [clip[r]!, clip[r + 4]!, clip[r + 8]!, clip[r + 12]!];
  const [a, b, c] = [row(0), row(1), row(3)];
  for (let i = 0; i < out.x.length; i++) {
    const x = points[3 * i]!;
    const y = points[3 * i + 1]!;
    const z = points[3 * i + 2]!;
    const w = c[0] * x + c[1] * y + c[2] * z + c[3];
    out.depth[i] = w;
    out.x[i] = (0.5 + (0.5 * (a[0] * x + a[1] * y + a[2] * z + a[3])) / w) * width;
    out.y[i] = (0.5 - (0.5 * (b[0] * x + b[1] * y + b[2] * z + b[3])) / w) * height;
  }
}

/** The point within `reach` pixels of x, y; among several the nearest to the camera that is about as near. -1: none. */
export function pointAt(screen: Screen, x: number, y: number, reach: (depth: number) => number): number {
  let best = -1;
  let least = Infinity;
  for (let i = 0; i < screen.x.length; i++) {
    const depth = screen.depth[i]!;
    if (depth <= 0) continue;
    const distance = Math.hypot(screen.x[i]! - x, screen.y[i]! - y);
    const score = distance / reach(depth);
    if (score < 1 && score * (0.2 + depth) < least) {
      least = score * (0.2 + depth);
      best = i;
    }
  }
  return best;
}

/** Where on a polyline the pointer is: index plus share of the piece behind it, and pixels away; null if farther than `reach`. */
export function lineAt(screen: Screen, x: number, y: number, reach: number): { index: number; pixels: number } | null {
  let best: { index: number; pixels: number } | null = null;
  for (let i = 0; i + 1 < screen.x.length; i++) {
    if (screen.depth[i]! <= 0 || screen.depth[i + 1]! <= 0) continue;
    const dx = screen.x[i + 1]! - screen.x[i]!;
    const dy = screen.y[i + 1]! - screen.y[i]!;
    const square = dx * dx + dy * dy;
    const along = square > 0 ? ((x - screen.x[i]!) * dx + (y - screen.y[i]!) * dy) / square : 0;
    const part = Math.min(1, Math.max(0, along));
    const pixels = Math.hypot(screen.x[i]! + part * dx - x, screen.y[i]! + part * dy - y);
    if (pixels <= reach && (!best || pixels < best.pixels)) best = { index: i + part, pixels };
  }
  return best;
}

// The chain as rings across it: from segment centres to centres, normals and radii of a tube, in arrays for the graphics card.

import type { ChainDef } from '../states/model';

/** Texels of a ring: centre and value; normal and radius; tangent and arc length. */
export const TEXELS = 3;
export const RINGS_A_ROW = 512;
/** Rings that a view draws at most, roughly. */
const RINGS = 3600;

/** A stretch of the chain with one diameter: its rings from `first` to `last`. */
export interface Stretch {
  first: number;
  last: number;
  part: number;
}

export class ChainRings {
  /** Where every ring stands along the chain, counted in segment centres; its segment; its arc length from the tail, m. */
  private readonly coordinate: Float32Array;
  private readonly arc: Float32Array;
  private readonly radius: Float32Array;
  readonly stretches: Stretch[] = [];
  /** RGBA texels, [ring][TEXELS][4], padded to whole rows. */
  readonly texels: Float32Array<ArrayBuffer>;
  readonly rows: number;

  constructor(private readonly chain: ChainDef) {
    const n = chain.segments;
    const steps = Math.min(4, Math.max(1, Math.round(RINGS / Math.max(1, n))));
    const coordinate: number[] = [];
    for (let from = 0; from < n;) {
      let to = from;
      while (
        to + 1 < n &&
        chain.diameter_m[to + 1] === chain.diameter_m[from] &&
        chain.part[to + 1] === chain.part[from]
      )
        to++;
      const first = coordinate.length;
      const pieces = (to - from + 1) * steps;
      for (let k = 0; k <= pieces; k++) coordinate.push(from - 0.5 + k / steps);
      this.stretches.push({ first, last: coordinate.length - 1, part: chain.part[from] ?? 0 });
      from = to + 1;
    }
    this.coordinate = Float32Array.from(coordinate);
    this.rows = Math.max(1, Math.ceil(coordinate.length / RINGS_A_ROW));
    this.texels = new Float32Array(this.rows * RINGS_A_ROW * TEXELS * 4);
    this.radius = new Float32Array(coordinate.length);
    for (const { first, last } of this.stretches) {
      const segment = Math.min(n - 1, Math.round(coordinate[first]! + 0.5));
      this.radius.fill(0.5 * (chain.diameter_m[segment] ?? 0.05), first, last + 1);
    }
    this.arc = this.arcs();
  }

  get count(): number {
    return this.coordinate.length;
  }

  private arcs(): Float32Array {
    const start = new Float64Array(this.chain.segments + 1);
    this.chain.length_m.forEach((length, i) => (start[i + 1] = start[i]! + length));
    return this.coordinate.map((c) => {
      const j = Math.min(this.chain.segments - 1, Math.floor(c + 0.5));
      return start[j]! + (c + 0.5 - j) * (this.chain.length_m[j] ?? 0);
    });
  }

  /** Fills `texels`: rings on a Catmull-Rom curve through the centres (xyz, m), values of the segments linearly between them. */
  update(centres: Float32Array, values: Float32Array): void {
    const { texels, coordinate } = this;
    const last = this.chain.segments - 1;
    for (let ring = 0; ring < this.count; ring++) {
      const c = coordinate[ring]!;
      const i1 = Math.min(Math.max(0, last - 1), Math.max(0, Math.floor(c)));
      const i2 = Math.min(last, i1 + 1);
      const i0 = Math.max(0, i1 - 1);
      const i3 = Math.min(last, i2 + 1);
      const u = c - i1;
      const to = 4 * TEXELS * ring;
      for (let x = 0; x < 3; x++) {
        const p1 = centres[3 * i1 + x]!;
        const p2 = centres[3 * i2 + x]!;
        if (u < 0 || u > 1) {
          texels[to + x] = p1 + u * (p2 - p1);
          continue;
        }
        const m1 = i0 < i1 ? 0.5 * (p2 - centres[3 * i0 + x]!) : p2 - p1;
        const m2 = i3 > i2 ? 0.5 * (centres[3 * i3 + x]! - p1) : p2 - p1;
        const d = p2 - p1;
        texels[to + x] = p1 + u * (m1 + u * (3 * d - 2 * m1 - m2 + u * (m1 + m2 - 2 * d)));
      }
      const v = Math.min(1, Math.max(0, u));
      texels[to + 3] = values[i1]! + v * (values[i2]! - values[i1]!);
      texels[to + 7] = this.radius[ring]!;
      texels[to + 11] = this.arc[ring]!;
    }
    for (const stretch of this.stretches) this.frame(stretch);
  }

  /** Tangents, and normals that turn as little as they can from ring to ring. */
  private frame({ first, last }: Stretch): void {
    const t = this.texels;
    const stride = 4 * TEXELS;
    let tx = 1;
    let ty = 0;
    let tz = 0;
    let nx = 0;
    let ny = 0;
    let nz = 0;
    for (let ring = first; ring <= last; ring++) {
      const a = stride * Math.max(first, ring - 1);
      const b = stride * Math.min(last, ring + 1);
      const dx = t[b]! - t[a]!;
      const dy = t[b + 1]! - t[a + 1]!;
      const dz = t[b + 2]! - t[a + 2]!;
      const length = Math.sqrt(dx * dx + dy * dy + dz * dz);
      // Rope that the winch took in is all at one point: the last tangent stays.
      if (length > 1e-6) {
        tx = dx / length;
        ty = dy / length;
        tz = dz / length;
      }
      let along = nx * tx + ny * ty + nz * tz;
      nx -= along * tx;
      ny -= along * ty;
      nz -= along * tz;
      let size = Math.sqrt(nx * nx + ny * ny + nz * nz);
      if (size < 0.1) {
        const steep = Math.abs(tz) > 0.9;
        along = steep ? tx : tz;
        nx = (steep ? 1 : 0) - along * tx;
        ny = -along * ty;
        nz = (steep ? 0 : 1) - along * tz;
        size = Math.sqrt(nx * nx + ny * ny + nz * nz);
      }
      nx /= size;
      ny /= size;
      nz /= size;
      const at = stride * ring;
      t[at + 4] = nx;
      t[at + 5] = ny;
      t[at + 6] = nz;
      t[at + 8] = tx;
      t[at + 9] = ty;
      t[at + 10] = tz;
    }
  }
}

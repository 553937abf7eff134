// The data that hawser writes into the page (docs/formats.md says what each key means): SI units, null where nothing is known.

import type { Assumption, ErrorBar, EventRow, LimitRow, Passes, Trust } from './columns';
export type { Assumption, ErrorBar, Pass, Passes, Trust } from './columns';

export type Value = number | null;
export type Point = [number, number, number];
/** A table by columns: texts in `name` and the like, numbers elsewhere. */
export type Columns = Record<string, (Value | string)[]>;

export interface Limit extends LimitRow {
  remedy?: string;
}

export interface PullEvent extends EventRow {
  time_s: number;
}

/** The keys of summary.json that the page reads; all of them may be missing in results of an older hawser. */
export interface Summary {
  title?: string;
  case?: string;
  version?: string;
  outcome?: string;
  message?: string;
  verdict?: string;
  /** Of format 1: sentences. */
  remedies?: ({ remedy: string; limit?: string; text: string } | string)[];
  analysis?: string;
  /** Of several chains that are pulled together, in the first one's summary: its own name, the others', and "all". */
  chains?: { name: string }[];
  pull_force?: {
    steady_mean_N: Value;
    peak_N: Value;
    steady_ripple_rms_N: Value;
    steady_mean_error?: ErrorBar | null;
    peak_error?: ErrorBar | null;
  };
  theory?: { paper_total_N: Value; reference_total_N: Value };
  tension_error?: { max_pct: Value; mean_pct: Value; max_pct_paper: Value; mean_pct_paper: Value };
  speed?: { steady_m_per_s: Value; settle_time_s: Value };
  steady_window?: { from_s: Value; to_s: Value };
  conveyors?: Record<string, Value | string>[];
  motors?: Record<string, Value | string>[];
  surfaces?: Record<string, Value | string>[];
  pull_by_position?: Record<string, Value>[];
  events?: PullEvent[];
  /** Of results that are older than it: none. */
  pieces?: Record<string, Value | string>[];
  limits?: Limit[];
  trust?: Trust[];
  passes?: Passes | null;
  assumptions?: Assumption[];
  overload?: { trip_N: Value; rollers?: Record<string, Value | string>[] };
  [key: string]: unknown;
}

export interface Input {
  key: string;
  value: string;
  origin: string;
  where?: string;
  source?: string;
}

export interface Envelope {
  s_m: Value[];
  tension_min_N?: Value[];
  tension_mean_N?: Value[];
  tension_max_N?: Value[];
  sidewall_max_N_per_m?: Value[];
  curvature_max_per_m?: Value[];
}

export interface Roller {
  name: string;
  s_m: Value;
  kind: string;
  position_m: Point;
  axis: Point;
  radius_m: Value;
  width_m: Value;
  rating_N: Value;
}

export interface Surface {
  from_m?: Value;
  to_m?: Value;
  name: string;
  kind: string;
  points_m: Point[];
  diameter_m?: Value;
  width_m?: Value;
  height_m?: Value;
  /** duct, flat, v or u. */
  section?: string;
  normal?: Point;
  /** Upward in its section, a point. */
  up?: Point[] | null;
}

/** A box or a bell-mouth among the rollers. */
export interface Obstacle {
  roller: number;
  side: Point;
  /** Along the roller's axis, its side, and across both. */
  size_m: Point;
  edge_m: Value;
  /** Radius of a bell-mouth; null: a box. */
  ring_m: Value;
}

export interface Conveyor {
  name: string;
  from_m: number;
  to_m: number;
  points_m: Point[];
}

export interface Geometry {
  origin_m: Point;
  up: Point;
  route: { s_m: number[]; position_m: Point[]; curvature_per_m: Value[] };
  rollers: Roller[];
  surfaces: Surface[];
  conveyors: Conveyor[];
  reel: { center_m: Point; axis: Point; radius_m: number; barrel_radius_m?: Value; width_m: number } | null;
  winch: { position_m: Point; direction: Point } | null;
  obstacles?: Obstacle[] | null;
}

/** The environment as it is shown; corners about the data's origin in steps, each list packed as a field of one frame. */
export interface Surroundings {
  /** Triangles and points of the models; and how far what is shown is from them at most. */
  given: number;
  error_m: Value;
  step_m: number;
  layers: string[];
  n_points: number;
  /** 0: more than this build of hawser can show. */
  n_triangles: number;
  points: string;
  /** Three points each; three equal ones are a point of a cloud. */
  triangles: string;
  layer: string;
}

export interface FieldMeta {
  components: number;
  unit: string;
  step: number;
}

export interface States {
  frames: number;
  segments: number;
  time_s: number[];
  head_at_m: Value[];
  fields: Record<string, FieldMeta>;
  packed: Record<string, string>;
}

export interface TheoryAlong {
  s_m: number[];
  /** The whole route full of cable, pulled either way. */
  forward_N?: Value[];
  backward_N?: Value[];
  paper_N?: Value[];
  /** What the steady window of the run is compared with. */
  run_N?: Value[];
  forward_sidewall_N_per_m?: Value[];
  curvature_per_m?: Value[];
}

export interface RunData {
  label: string;
  summary: Summary;
  stations?: Columns | null;
  rollers?: Columns | null;
  series?: (Columns & { thinned_from?: unknown }) | null;
  inputs?: Input[] | null;
  /** Sentences: what is missing or could not be read. */
  notes?: string[];
  theory_along?: TheoryAlong | null;
  geometry?: Geometry | null;
  environment?: Surroundings | null;
  chain?: { segments: number; length_m: number[]; diameter_m: number[]; part: number[]; part_names: string[] } | null;
  envelope?: { place?: Envelope; arc?: Envelope } | null;
  roller_force?: (FieldMeta & { packed: string }) | null;
  states?: States | null;
}

export interface ReportData {
  format: number;
  hawser: string;
  generated?: string;
  runs: RunData[];
}

/** The other chains that are pulled together with a run's: the first of them names all, and their folders are in its own. */
export function pulledWith(runs: readonly RunData[], run: RunData): RunData[] {
  const folder = (first: RunData, name: string): string => `${first.label}/${name}`;
  for (const first of runs) {
    const names = (first.summary.chains ?? []).map((chain) => chain.name);
    const all = runs.filter((each) => each === first || names.some((name) => each.label === folder(first, name)));
    if (all.length > 1 && all.includes(run)) return all.filter((each) => each !== run);
  }
  return [];
}

/** A rod lies along no route: its lists are empty then, not absent. */
export function withoutRoute({ geometry }: RunData): void {
  if (geometry && !(geometry.route as { s_m: number[] | null }).s_m) {
    geometry.route = { s_m: [], position_m: [], curvature_per_m: [] };
  }
}

/** Reads the data out of the page; throws with a sentence for the reader where there is none or it is of another format. */
export function readData(page: Document): ReportData {
  const text = page.getElementById('hawser-data')?.textContent;
  if (!text) throw new Error('This page holds no data of a run.');
  const data = JSON.parse(text) as ReportData;
  if (data.format !== 1)
    throw new Error(`The data of this page are of format ${String(data.format)}; the page reads 1.`);
  if (!Array.isArray(data.runs) || data.runs.length === 0) throw new Error('The data of this page hold no run.');
  data.runs.forEach(withoutRoute);
  return data;
}

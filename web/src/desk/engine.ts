/** The engine as the desk sees it: texts in, texts out. Behind it is a worker with WebAssembly; a local server could take the same calls. */
import type { Spot } from './arc';

/** What the library says when something is wrong; `line` counts from 1, 0: none. */
export interface Fault {
  status: number;
  message: string;
  key: string;
  file: string;
  line: number;
}

export class EngineError extends Error {
  constructor(readonly fault: Fault) {
    super(fault.message);
  }
}

/** What went wrong, in words. */
export const messageOf = (why: unknown): string => (why instanceof Error ? why.message : String(why));

export interface Remedy {
  direction: string;
  remedy: string;
  where: string;
  key: string;
  now: number | null;
  value: number | null;
  unit: string;
  verdict_code: string;
}

/** What the desk reads of `hawser theory --format json`. */
export interface Theory {
  title: string;
  verdict_code: string;
  verdict_forward: string;
  verdict_backward: string;
  verdict_code_backward: string;
  length_m: number;
  largest_force_N: number;
  backward_largest_force_N: number;
  max_sidewall_N_per_m: number;
  better_direction: string;
  remedies?: Remedy[];
  limits?: Limit[];
  ducts?: Duct[];
  /** Of several chains that are pulled together, each under its name; nothing else stands beside it then. */
  theory?: Record<string, Theory>;
}

/** A line of a drawing, table or map. */
export interface RouteLine {
  name: string;
  layer: string;
  length_m: number;
  pieces: number;
  problem?: string | null;
}

/** What is drawn along the route (web/engine/along.c): m, N, N/m; coordinates are the case's. */
export interface Along {
  s_m: number[];
  x_m: number[];
  y_m: number[];
  z_m: number[];
  forward_N: (number | null)[];
  backward_N: (number | null)[];
  forward_sidewall_N_per_m: (number | null)[];
  backward_sidewall_N_per_m: (number | null)[];
  north_deg: number | null;
  pieces: Piece[];
  stands: { equipment: Stand[] };
}

export type Vector = [number, number, number];

export interface Piece {
  /** Which item of the route's list it is, from 1 on; 0: none. */
  listed: number;
  kind: 'straight' | 'bend' | 'curve' | 'cubic';
  name: string;
  s_m: number;
  length_m: number;
  radius_m: number | null;
  angle_deg: number;
  start: Vector;
  tangent: Vector;
  /** Of a bend: from its start toward its centre. */
  centre: Vector;
}

export interface Stand {
  kind: 'roller' | 'hold-down' | 'guide' | 'conveyor' | 'machine' | 'pit' | 'winch' | 'reel';
  name: string;
  station_m: number;
  x_m: number;
  y_m: number;
  z_m: number;
  load_N: number | null;
  rating_N: number | null;
  margin_pct: number | null;
}

export interface Entry {
  name: string;
  figures: string;
  ranges: string;
  mark: string;
  note: string;
  source: string;
}

export interface Limit {
  direction: string;
  name: string;
  value: number | null;
  limit: number | null;
  unit: string;
  margin: number | null;
  where: string;
  ok: string;
}

export interface Duct {
  name: string;
  cables: number;
  layout: string;
  weight_factor: number;
  jam_ratio: number | null;
  jam_risk: string;
  clearance_m: number;
  fill: number;
}

export type Call =
  | 'theory'
  | 'answer'
  | 'page'
  | 'schema'
  | 'route'
  | 'lines'
  | 'section'
  | 'along'
  | 'library'
  | 'words'
  | 'cost'
  | 'run'
  | 'report';

/** The place of a name that a case gives: the case is in /case, '../x.csv' is beside that folder. */
export const placeOf = (name: string): string =>
  decodeURIComponent(new URL(name.split('/').map(encodeURIComponent).join('/'), 'file:///case/').pathname);

/** Folders of the engine's own. */
const OWN = /^\/(library|web|run|dev|proc|tmp)\//;

/** Files by their places. */
export type Files = ReadonlyMap<string, Uint8Array<ArrayBuffer>>;

/** What goes to the worker, and what comes back under the same number. */
export interface Request {
  id: number;
  call?: Call;
  args?: (string | number)[];
  /** At its place; null: it is taken away. */
  file?: { place: string; bytes: Uint8Array | null };
  start?: ArrayBuffer;
}
export interface Reply {
  id: number;
  text?: string;
  fault?: Fault;
  /** What a run shows meanwhile; the answer itself comes later. */
  shown?: Shown;
  /** The report's page of a run that is over; of one that failed, as far as it was. */
  report?: string;
  /** The folder of a run as it is by now. */
  kept?: Files;
}

/** First the report's data of a run that has begun, then its moments. */
export type Shown = { data: string } | Moment;
export interface Moment {
  time: number;
  end: number;
  wall: number;
  /** 1; 2 and 3 are finer ones. */
  pass: number;
  force: number;
  most: number;
  reference: number;
  head: number;
  position: Float32Array;
  tension: Float32Array;
  /** What makes the run slow, in words. */
  heldUp: string;
}

export class Engine {
  private readonly waiting = new Map<number, { done: (text: string) => void; failed: (why: Error) => void }>();
  private last = 0;
  private started: Promise<string> = new Promise(() => undefined);
  /** What has been put beside the case, by its place: a run takes it along. */
  files: Files = new Map();

  constructor(private readonly worker: Worker) {
    worker.onmessage = (event: MessageEvent<Reply>) => {
      const { id, text, fault } = event.data;
      const one = this.waiting.get(id);
      this.waiting.delete(id);
      if (fault) one?.failed(new EngineError(fault));
      else one?.done(text ?? '');
    };
    worker.onerror = (event) => {
      for (const one of this.waiting.values()) one.failed(new Error(event.message));
      this.waiting.clear();
    };
  }

  private ask(request: Omit<Request, 'id'>, move: Transferable[] = []): Promise<string> {
    const id = ++this.last;
    return new Promise((done, failed) => {
      this.waiting.set(id, { done, failed });
      this.worker.postMessage({ id, ...request }, move);
    });
  }

  /** Hands over the module's bytes; the answer comes when it can be called. */
  start(module: ArrayBuffer): Promise<string> {
    this.started = this.ask({ start: module }, [module]);
    return this.started;
  }

  /** These are the files of the case from now on, and no others. */
  async hold(files: Files): Promise<void> {
    await this.started;
    const before = this.files;
    this.files = new Map([...files].filter(([place]) => !OWN.test(place)));
    const gone = [...before.keys()].filter((place) => !this.files.has(place));
    await Promise.all([
      ...gone.map((place) => this.ask({ file: { place, bytes: null } })),
      ...[...this.files]
        .filter(([place, bytes]) => before.get(place) !== bytes)
        .map(([place, bytes]) => this.ask({ file: { place, bytes } })),
    ]);
  }

  /** A function of web/engine/desk.c by its name. */
  call(call: Call, ...args: (string | number)[]): Promise<string> {
    return this.ask({ call, args });
  }

  async theory(text: string, tables = 'all'): Promise<Theory> {
    return JSON.parse(await this.call('theory', text, tables)) as Theory;
  }

  async along(text: string): Promise<Along> {
    return JSON.parse(await this.call('along', text)) as Along;
  }

  async library(kind: string): Promise<Entry[]> {
    return (JSON.parse(await this.call('library', kind)) as { entries: Entry[] }).entries;
  }

  /** Texts of the program in a language by its number: 0 English, 1 Chinese, 2 German. */
  async words(texts: string[], language: number): Promise<string[]> {
    return language ? (JSON.parse(await this.call('words', JSON.stringify(texts), language)) as string[]) : texts;
  }

  answer(text: string, us: boolean): Promise<string> {
    return this.call('answer', text, us ? 1 : 0);
  }

  /** language: of a case that names none; "": none. */
  page(text: string, us: boolean, language: string): Promise<string> {
    return this.call('page', text, us ? 1 : 0, language);
  }

  /** The section `route` of a case for the line of a file; comments and the zeros at the ends of its numbers are gone. */
  async section(file: string, name: string, layer: string): Promise<string> {
    const said = await this.call('section', file, name, layer);
    return said
      .replace(/^#.*\n/gm, '')
      .replace(/(\d\.\d*?)0+(?= (?:m|deg)\b)/g, '$1')
      .replace(/\.(?= (?:m|deg)\b)/g, '')
      .trimEnd();
  }

  /** All lines of a file in plan, m, as the file has them; `units`: in place of what the file says, or "". */
  async lines(file: string, units: string): Promise<Spot[][]> {
    const found = JSON.parse(await this.call('lines', file, units)) as number[][];
    return found.map((line) => line.flatMap((x, i): Spot[] => (i % 2 ? [] : [[x, line[i + 1] ?? 0]])));
  }

  async route(name: string): Promise<RouteLine[]> {
    const said = JSON.parse(await this.call('route', name)) as { alignments: RouteLine[] };
    return said.alignments;
  }
}

/** A script's text as a worker, also on a page that was opened from disk. */
export function workerOf(script: string): Worker {
  const url = URL.createObjectURL(new Blob([script], { type: 'text/javascript' }));
  return new Worker(url);
}

/** Bytes that are in the page, as base64; deflated ones, too. */
export const bytesOf = (base64: string): Uint8Array<ArrayBuffer> =>
  Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));

export async function inflated(base64: string): Promise<ArrayBuffer> {
  const stream = new Blob([bytesOf(base64)]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
  return new Response(stream).arrayBuffer();
}

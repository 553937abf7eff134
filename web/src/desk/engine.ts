/** The engine as the desk sees it: texts in, texts out. Behind it is a worker with WebAssembly; a local server could take the same calls. */

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
  remedies?: Remedy[];
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

export type Call = 'theory' | 'answer' | 'page' | 'schema' | 'route' | 'cost' | 'run';

/** What goes to the worker, and what comes back under the same number. */
export interface Request {
  id: number;
  call?: Call;
  args?: (string | number)[];
  file?: { name: string; bytes: Uint8Array };
  start?: ArrayBuffer;
}
export interface Reply {
  id: number;
  text?: string;
  fault?: Fault;
  /** What a run shows meanwhile; the answer itself comes later. */
  shown?: Shown;
  /** The report's page of a run that is over. */
  report?: string;
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
  /** What has been put beside the case: a run takes it along. */
  readonly files = new Map<string, Uint8Array>();

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
    return this.ask({ start: module }, [module]);
  }

  /** Puts a file beside the case. */
  put(name: string, bytes: Uint8Array): Promise<string> {
    this.files.set(name, bytes);
    return this.ask({ file: { name, bytes } });
  }

  /** A function of web/engine/desk.c by its name. */
  call(call: Call, ...args: (string | number)[]): Promise<string> {
    return this.ask({ call, args });
  }

  async theory(text: string): Promise<Theory> {
    return JSON.parse(await this.call('theory', text, 'all')) as Theory;
  }

  answer(text: string, us: boolean): Promise<string> {
    return this.call('answer', text, us ? 1 : 0);
  }

  page(text: string, us: boolean): Promise<string> {
    return this.call('page', text, us ? 1 : 0);
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

/** Bytes that are in the page, deflated and as base64. */
export async function inflated(base64: string): Promise<ArrayBuffer> {
  const packed = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
  return new Response(stream).arrayBuffer();
}

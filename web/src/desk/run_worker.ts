/** A run of the engine in a worker of its own, which goes on while the desk is used, and ends at once when it is told to. */
import { EngineError, type Moment, type Reply, type Request, workerOf } from './engine';

/** Which request an answer is of. */
const START = 1;
const FILE = 2;
const RUN = 3;

export interface RunParts {
  script: string;
  module: ArrayBuffer;
  /** Beside the case, by their names; and what the report's page is made of. */
  files: ReadonlyMap<string, Uint8Array>;
}

export interface RunEnd {
  /** summary.json and the report's page. */
  summary: string;
  report: string;
}

export class Run {
  readonly done: Promise<RunEnd>;
  private readonly worker: Worker;
  private fail: (why: Error) => void = () => undefined;

  /** begun: the report's data of the scene. */
  constructor(parts: RunParts, text: string, begun: (data: string) => void, moment: (moment: Moment) => void) {
    this.worker = workerOf(parts.script);
    this.done = new Promise((done, failed) => {
      this.fail = failed;
      this.worker.onerror = (event) => failed(new Error(event.message));
      this.worker.onmessage = ({ data: { id, text: said, fault, shown, report } }: MessageEvent<Reply>) => {
        if (id === START && !fault) {
          for (const [name, bytes] of parts.files) post(FILE, { file: { name, bytes } });
          post(RUN, { call: 'run', args: [text] });
        } else if (shown) {
          if ('data' in shown) begun(shown.data);
          else moment(shown);
        } else if (fault) {
          failed(new EngineError(fault));
        } else if (id === RUN) {
          done({ summary: said ?? '', report: report ?? '' });
        }
      };
    });
    void this.done.catch(() => undefined).then(() => this.worker.terminate());
    const post = (id: number, request: Omit<Request, 'id'>): void => this.worker.postMessage({ id, ...request });
    post(START, { start: parts.module });
  }

  stop(): void {
    this.worker.terminate();
    this.fail(new Stopped());
  }
}

export class Stopped extends Error {}

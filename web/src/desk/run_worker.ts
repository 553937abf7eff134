/** A run of the engine in a worker of its own, which goes on while the desk is used, and ends at once when it is told to. What it had written
 * by then is at hand: another worker makes the report of it. */
import { type Call, type Fault, type Files, type Moment, type Reply, type Request, workerOf } from './engine';

/** Which request an answer is of. */
const START = 1;
const FILE = 2;
const RUN = 3;

export interface RunParts {
  script: string;
  module: ArrayBuffer;
  /** Beside the case, by their names; and what the report's page is made of. */
  files: Files;
}

export interface RunEnd {
  /** summary.json and the report's page; '': there is none. */
  summary: string;
  report: string;
  /** Why it ended before its time. */
  fault?: Fault;
}

export class Run {
  readonly done: Promise<RunEnd>;
  /** The folder of the run as it was a moment ago. */
  kept: Files = new Map();
  private readonly worker: Worker;
  private fail: (why: Error) => void = () => undefined;

  /** call: a run of a text, or the report of a folder's files; begun: the report's data of the scene. */
  constructor(
    parts: RunParts,
    call: { call: Call; args: string[] },
    begun: (data: string) => void = () => undefined,
    moment: (moment: Moment) => void = () => undefined,
  ) {
    this.worker = workerOf(parts.script);
    this.done = new Promise((done, failed) => {
      this.fail = failed;
      this.worker.onerror = (event) => failed(new Error(event.message));
      this.worker.onmessage = ({ data: { id, text: said, fault, shown, report, kept } }: MessageEvent<Reply>) => {
        if (id === START && !fault) {
          for (const [place, bytes] of parts.files) post(FILE, { file: { place, bytes } });
          post(RUN, call);
        } else if (kept) {
          this.kept = kept;
        } else if (shown) {
          if ('data' in shown) begun(shown.data);
          else moment(shown);
        } else if (fault || id === RUN) {
          done({ summary: said ?? '', report: report ?? '', ...(fault && { fault }) });
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

// The converter's script: called by node it is the child process of `hawser convert`, in a worker of the desk it answers messages.
import { convert, Refused } from './convert';

interface NodeProcess {
  argv: string[];
  exitCode?: number;
  versions?: { node?: string };
}
interface Files {
  readFileSync(path: string): Uint8Array;
  writeFileSync(path: string, bytes: Uint8Array): void;
  writeSync(fd: number, text: string): void;
}
declare const process: NodeProcess | undefined;
declare const require: (name: string) => unknown;

/** Loaders write warnings; what is to be read is in the notes. */
const quiet = (): void => {
  for (const name of ['log', 'info', 'warn', 'error', 'debug'] as const) console[name] = () => {};
};

/** What a user is told of a failure. */
function reason(error: unknown): string {
  if (error instanceof Refused) return error.message;
  const words = error instanceof Error ? error.message : String(error);
  return `it cannot be converted: ${words.replaceAll(/\s+/g, ' ').slice(0, 300)}`;
}

/** node convert.cjs MODEL GLB UNIT UP, GLB a file that is open for writing or its name: lines "note: ...", "done: ..." or "error: ..." on standard output; status 0 or 2. */
async function inNode(process: NodeProcess): Promise<void> {
  const files = require('node:fs') as Files;
  const say = (kind: string, text: string): void => files.writeSync(1, `${kind}: ${text.replaceAll(/\s+/g, ' ')}\n`);
  const [path = '', to = '', unit, up] = process.argv.slice(2);
  quiet();
  try {
    const made = await convert(path, files.readFileSync(path), { unit: unit || null, up: up || null });
    files.writeFileSync(to, made.glb);
    for (const note of made.notes) say('note', note);
    const shapes = [made.triangles && `${made.triangles} triangles`, made.points && `${made.points} points`];
    say('done', `${shapes.filter(Boolean).join(', ')} in ${made.nodes} nodes`);
  } catch (error) {
    say('error', reason(error));
    process.exitCode = 2;
  }
}

interface Asked {
  name: string;
  bytes: Uint8Array;
  unit: string | null;
  up: string | null;
}

function inWorker(): void {
  quiet();
  onmessage = ({ data: { name, bytes, ...options } }: MessageEvent<Asked>) => {
    convert(name, bytes, options).then(
      (made) => postMessage(made, { transfer: [made.glb.buffer] }),
      (error: unknown) => postMessage({ error: reason(error) }),
    );
  };
}

if (typeof process !== 'undefined' && process.versions?.node) void inNode(process);
else if ('WorkerGlobalScope' in globalThis) inWorker();

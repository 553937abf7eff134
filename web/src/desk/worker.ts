/** The worker: emscripten's module, one call after the other. `hawserEngine` is the module's script, which stands before this one. */
import type { Fault, Reply, Request, Shown } from './engine';

interface Module {
  FS: {
    mkdir(path: string): void;
    readFile(path: string, options: { encoding: 'utf8' }): string;
    readFile(path: string): Uint8Array<ArrayBuffer>;
    readdir(path: string): string[];
    stat(path: string): { mode: number };
    isFile(mode: number): boolean;
    analyzePath(path: string): { exists: boolean };
    mkdirTree(path: string): void;
    unlink(path: string): void;
    writeFile(path: string, bytes: Uint8Array): void;
  };
  ENV: Record<string, string>;
  UTF8ToString(at: number): string;
  stringToUTF8(text: string, at: number, size: number): void;
  lengthBytesUTF8(text: string): number;
  _malloc(size: number): number;
  _free(at: number): void;
}
declare const hawserEngine: (options: object) => Promise<Module>;

let engine: Module | undefined;
let running = 0; // the request that is a run

function call(module: Module, name: string, args: (string | number)[]): string {
  const places = args.map((value) => {
    if (typeof value === 'number') return value;
    const size = module.lengthBytesUTF8(value) + 1;
    const at = module._malloc(size);
    module.stringToUTF8(value, at, size);
    return at;
  });
  const named = module as unknown as Record<string, (...places: number[]) => number>;
  const at = named[`_desk_${name}`]?.(...places) ?? 0;
  const text = at ? module.UTF8ToString(at) : '';
  module._free(at);
  args.forEach((value, i) => typeof value === 'string' && module._free(places[i] ?? 0));
  return text;
}

/** Hands over the folder of the run. */
function keep(): void {
  if (!engine) return;
  const { FS } = engine;
  const paths = FS.readdir('/run').map((name) => `/run/${name}`);
  const kept = new Map(paths.filter((path) => FS.isFile(FS.stat(path).mode)).map((path) => [path, FS.readFile(path)]));
  postMessage({ id: running, kept }, { transfer: [...kept.values()].map((bytes) => bytes.buffer) });
}

const broken = (message: string): Fault => ({ status: 5, message, key: '', file: '', line: 0 });

async function answer(request: Request): Promise<Reply> {
  const { id } = request;
  if (request.start) {
    engine = await hawserEngine({
      wasmBinary: request.start,
      onRun: (shown: Shown) => postMessage({ id: running, shown }),
      onKeep: keep,
      preRun: [(module: Module) => (module.ENV['HAWSER_LIBRARY'] = '/library')],
    });
    engine.FS.mkdir('/case');
    return { id };
  }
  if (!engine) return { id, fault: broken('the engine has not started') };
  if (request.file) {
    const { place, bytes } = request.file;
    engine.FS.mkdirTree(place.slice(0, place.lastIndexOf('/')) || '/');
    if (bytes) engine.FS.writeFile(place, bytes);
    else if (engine.FS.analyzePath(place).exists) engine.FS.unlink(place);
    return { id };
  }
  running = id;
  const text = call(engine, request.call ?? '', request.args ?? []);
  const report = engine.FS.analyzePath('/report.html').exists
    ? { report: engine.FS.readFile('/report.html', { encoding: 'utf8' }) }
    : {};
  if (text.startsWith('=')) return { id, text: text.slice(1), ...report };
  return { id, ...report, fault: text ? (JSON.parse(text.slice(1)) as Fault) : broken('there is not enough memory') };
}

onmessage = (event: MessageEvent<Request>) => {
  answer(event.data).then(
    (reply) => postMessage(reply),
    (why: unknown) => postMessage({ id: event.data.id, fault: broken(String(why)) }),
  );
};

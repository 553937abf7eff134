/** Models of a tunnel in the desk: the converter in a worker, which is unpacked when the first model is opened. */
import type { Converted } from '../convert/convert';
import { inflated, workerOf } from './engine';
import { t } from './words';

/** Kinds that the engine reads, and kinds that become GLB first. */
export const READ = /\.(glb|stl)$/i;
export const CONVERTED = /\.(ifc|obj|ply|dae|fbx|3ds|3mf|xyz)$/i;
/** Kinds that do not say their unit and axis. */
const SILENT = /\.(obj|ply|3ds|xyz|stl)$/i;
const TIME_MS = 300_000;

export interface Told {
  unit: string | null;
  up: string | null;
}

/** What the file does not say, from its owner; null: nothing was given. */
export function asked(name: string): Told | null {
  if (!SILENT.test(name)) return { unit: null, up: null };
  const unit = window.prompt(t('Unit of length of {1}: m, cm, mm, in or ft', name), 'm');
  const up = unit && window.prompt(t('Axis of {1} that points up: y or z', name), 'z');
  return unit && up ? { unit: unit.trim(), up: up.trim() } : null;
}

/** The model as GLB; throws with what is wrong with it. */
export async function converted(name: string, bytes: Uint8Array, told: Told): Promise<Converted> {
  const script = await inflated(document.getElementById('converter')?.textContent ?? '');
  const worker = workerOf(new TextDecoder().decode(script));
  try {
    return await new Promise((done, failed) => {
      setTimeout(() => failed(new Error(t('The conversion takes more than {1} s.', String(TIME_MS / 1000)))), TIME_MS);
      worker.onerror = (event) => failed(new Error(event.message));
      worker.onmessage = ({ data }: MessageEvent<Converted | { error: string }>) =>
        'error' in data ? failed(new Error(data.error)) : done(data);
      worker.postMessage({ name, bytes, ...told });
    });
  } finally {
    worker.terminate();
  }
}

/** The lines of a case that take a model; STL says neither unit nor axis in itself. */
export function item(file: string, told: Told | null): string {
  const more = READ.test(file) && told?.unit ? `\n    unit: 1 ${told.unit}\n    up: ${told.up}` : '';
  return `  - file: ${JSON.stringify(file)}${more}`;
}

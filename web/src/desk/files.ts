/** The files that a case names. With its text they are all that the desk knows of a case: they are kept with the draft, and saved with the
 * text as one archive that opens elsewhere. A file has its place as its name: the case is in the folder /case, as for the engine. */
import { strFromU8, strToU8, unzipSync, zipSync } from 'fflate';
import { placeOf, type Files } from './engine';
import { READ } from './models';
import { filesOf } from './splice';

/** What holds lines that can be a route. */
export const ROUTES = /\.(csv|tsv|xlsx|ods|dxf|xml|landxml|ifc|gpx|kml|kmz|geojson|geojsonl)$/i;
export const CASES = /\.ya?ml$/i;
/** Shapefiles are several files, which the engine in a browser does not read. */
export const SHAPES = /\.(shp|shx|dbf|prj|cpg)$/i;

/** Bytes of an archive's content that are taken at most: what is larger is no case. */
const MOST = 500e6;

/** The files that a text names, by their places. */
export const namedBy = (text: string): string[] => [
  ...new Set(
    filesOf(text)
      .filter((name) => ROUTES.test(name) || CASES.test(name) || READ.test(name))
      .map(placeOf),
  ),
];

/** An archive of a case and all its files; undefined: it names none that is there. `text`: as it goes into its file. */
export function packed(name: string, text: string, files: Files): Uint8Array<ArrayBuffer> | undefined {
  if (!namedBy(text).some((place) => files.has(place))) return undefined;
  const all = new Map([...files, [`/case/${name}`, strToU8(text)]]);
  const inside = [...all.keys()].every((place) => place.startsWith('/case/'));
  const entry = (place: string): string => place.slice(inside ? '/case/'.length : 1);
  return zipSync(Object.fromEntries([...all].map(([place, bytes]) => [entry(place), bytes])));
}

/** Where a file of this name belongs: where the case names one that is called so, or beside the case. */
export function placesFor(text: string, name: string): string[] {
  const named = namedBy(text).filter((place) => place.endsWith(`/${name}`));
  return named.length ? named : [`/case/${name}`];
}

/** A case with its files, by their places. */
export interface CaseSet {
  name: string;
  text: string;
  files: Files;
}

/** The case among files: the one that names most of the others. undefined: there is none. */
export function mainOf<One extends { name: string; bytes: Uint8Array }>(
  all: One[],
): (One & { text: string }) | undefined {
  return all
    .filter((one) => CASES.test(one.name))
    .map((one) => ({ ...one, text: strFromU8(one.bytes) }))
    .sort((a, b) => namedBy(b.text).length - namedBy(a.text).length)[0];
}

/** The case in an archive; undefined: there is none. */
export function unpacked(archive: Uint8Array): CaseSet | undefined {
  let size = 0;
  const found = Object.entries(
    unzipSync(archive, {
      filter: (one) => {
        size += one.originalSize;
        return size <= MOST && !one.name.endsWith('/');
      },
    }),
  );
  if (size > MOST) return undefined;
  const entries = found.map(([name, bytes]) => ({ name, bytes }));
  const main = mainOf(entries);
  if (!main) return undefined;
  const cut = main.name.lastIndexOf('/') + 1;
  const folder = main.name.slice(0, cut);
  const place = (path: string): string => (path.startsWith(folder) ? `/case/${path.slice(cut)}` : `/${path}`);
  const others = entries.filter(({ name }) => name !== main.name);
  return {
    name: main.name.slice(cut),
    text: main.text,
    files: new Map(others.map((one) => [place(one.name), one.bytes])),
  };
}

// -------------------------------------------------------------------------------------------------- with the draft

const STORE = 'files';

/** A browser that keeps nothing for pages from disk fails here. */
function store<T>(mode: IDBTransactionMode, work: (files: IDBObjectStore) => IDBRequest<T>): Promise<T> {
  return new Promise((done, failed) => {
    const request = indexedDB.open('hawser-desk', 1);
    request.onupgradeneeded = () => request.result.createObjectStore(STORE);
    request.onerror = () => failed(request.error ?? new Error());
    request.onsuccess = () => {
      const asked = work(request.result.transaction(STORE, mode).objectStore(STORE));
      asked.onsuccess = () => done(asked.result);
      asked.onerror = () => failed(asked.error ?? new Error());
      asked.transaction?.addEventListener('complete', () => request.result.close());
    };
  });
}

/** Keeps the files of a draft, by the draft's key. */
export const keepFiles = async (key: string, files: Files): Promise<void> => {
  await store('readwrite', (all) => all.put(new Map(files), key)).catch(() => undefined);
};
export const keptFiles = (key: string): Promise<Files> =>
  store('readonly', (all) => all.get(key) as IDBRequest<Files | undefined>).then(
    (found) => found ?? new Map(),
    () => new Map(),
  );
export const forgetFiles = async (key: string): Promise<void> => {
  await store('readwrite', (all) => all.delete(key)).catch(() => undefined);
};

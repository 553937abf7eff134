/** The desk: a case's text on the left, what theory says of it on the right, always of the text as it stands. */
import { basicSetup } from 'codemirror';
import { autocompletion } from '@codemirror/autocomplete';
import { redo, undo } from '@codemirror/commands';
import { EditorView } from '@codemirror/view';
import { EditorState } from '@codemirror/state';
import { yaml } from '@codemirror/lang-yaml';
import { HighlightStyle, syntaxHighlighting } from '@codemirror/language';
import { tags } from '@lezer/highlight';
import { lintGutter, setDiagnostics, type Diagnostic } from '@codemirror/lint';
import ductText from '../../../docs/tutorial/duct-first.yaml';
import tunnelText from '../../../docs/tutorial/tunnel.yaml';
import plannerText from '../../../cases/theory/planner.yaml';
import threeText from '../../../cases/three-in-a-duct.yaml';
import rollersText from '../../../cases/huangjiahu.yaml';
import limitsText from '../../../cases/limits.yaml';
import { el } from '../dom';
import { Catalogue } from './catalogue';
import { completions, type Schema } from './complete';
import { newest, Place, quantity, worstChain, writtenAt, type Desk } from './desk';
import {
  bytesOf,
  Engine,
  EngineError,
  inflated,
  messageOf,
  placeOf,
  workerOf,
  type Along,
  type Fault,
  type Files,
  type Remedy,
  type Theory,
} from './engine';
import { Equipment } from './equipment';
import {
  CASES,
  forgetFiles,
  keepFiles,
  keptFiles,
  mainOf,
  namedBy,
  packed,
  placesFor,
  ROUTES,
  SHAPES,
  unpacked,
} from './files';
import { Help } from './help';
import { markedLine, showLine } from './marked_line';
import { Plan } from './plan';
import { button, markRoute, routeView } from './route';
import { Simulation } from './simulate';
import { asked as unitOf, CONVERTED, converted, item, READ } from './models';
import { nodeAt, parsed, pathOf, putSection, setValue, type Change } from './splice';
import { Start } from './start';
import { Strips } from './strips';
import { Tabs } from './tabs';
import { valuesView } from './values';
import { forgetVariants, Variants } from './variants';
import { WhatIf } from './whatif';
import { LANGUAGES, languageNow, languageNumber, setLanguage, t, translate, withoutRow, type Language } from './words';

const EXAMPLES: [string, string][] = [
  ['A cable in a duct', ductText],
  ['Three cables in a duct', threeText],
  ['Ducts with a pit between', plannerText],
  ['A tunnel with rollers', tunnelText],
  ['Rollers and their loads', limitsText],
  ['The tunnel of the paper', rollersText],
];
interface Draft {
  name: string;
  text: string;
}
const DRAFT = 'hawser-desk-draft';

/** An element of the page, which is of this class. */
function part<T extends HTMLElement>(id: string, of: new () => T): T;
function part(id: string): HTMLElement;
function part(id: string, of: new () => HTMLElement = HTMLElement): HTMLElement {
  const found = document.getElementById(id);
  if (!(found instanceof of)) throw new Error(`the page has no ${of.name} "${id}"`);
  return found;
}
const text = (id: string): string => part(id).textContent;

const SETTINGS = 'hawser-desk-settings';
let us = false;
let simulation: Simulation | undefined;
let saved = '';
let eol = '\n'; // how the lines of the case's file end
let given: (Draft & { files?: Record<string, string> }) | null = null; // files: by their names, as base64
let name = 'case.yaml';

// ------------------------------------------------------------------------------------------------------------ the text

let engine: Engine | undefined;
let theory: Theory | undefined; // of the last text that was a case
let along: Along | undefined;
let page = ''; // the calculation of the text as it stands, or ''
let schema: Schema | undefined;
let ready = false; // it can be called
let complete: ReturnType<typeof completions> | undefined; // once the engine has said what a case may hold
let wanted = 0;
let done = 0; // the last of them that was calculated
let busy = false;

/** The style sheet says which colours these are, by day and by night. */
const colours = HighlightStyle.define([
  { tag: tags.definition(tags.propertyName), color: 'var(--key)' },
  { tag: tags.comment, color: 'var(--comment)' },
  { tag: [tags.string, tags.content], color: 'var(--word)' },
]);

const view = new EditorView({
  parent: part('editor'),
  state: state(''),
});

function state(doc: string): EditorState {
  return EditorState.create({
    doc,
    extensions: [
      basicSetup,
      yaml(),
      syntaxHighlighting(colours),
      EditorView.theme({}, { dark: matchMedia('(prefers-color-scheme: dark)').matches }),
      autocompletion({ override: [(context) => complete?.(context) ?? null] }),
      lintGutter(),
      markedLine,
      EditorView.lineWrapping,
      EditorView.contentAttributes.of({ 'aria-label': t('The case as text') }),
      EditorView.updateListener.of((update) => {
        if (!update.docChanged) return;
        keep();
        ask();
      }),
    ],
  });
}

const current = (): string => view.state.doc.toString();

/** Another case on the desk. */
function take(doc: string, as: string): void {
  eol = doc.includes('\r\n') ? '\r\n' : '\n';
  name = as;
  under = '';
  plan.lay([]);
  view.setState(state(doc));
  saved = current();
  title();
  if (languageOf() !== languageNow()) speak(languageOf());
  views();
  ask();
}

/** files: those of the case, by their places. */
function open(doc: string, as: string, files: Files = new Map()): void {
  if (current() !== saved && !confirm(t('The case has changes that are not saved. Leave them?'))) return;
  say('');
  take(doc, as);
  keep();
  void hold(files);
}

/** Other files of the case, which are kept with its draft. */
async function hold(files: Files): Promise<void> {
  await engine?.hold(files);
  await keepFiles(draftKey(), engine?.files ?? files);
  ask();
}

function title(): void {
  part('name').textContent = name + (current() === saved ? '' : ' *');
}

/** The draft of a case that `hawser desk CASE` has put into the page is another one than that of the desk. */
const draftKey = (): string => (given ? `${DRAFT}:${given.name}` : DRAFT);

function keep(): void {
  title();
  try {
    localStorage.setItem(draftKey(), JSON.stringify({ name, text: current() }));
  } catch {
    // a browser that keeps nothing for pages from disk: there is no draft then
  }
}

let pointing = false; // a button of the mouse is down: what it is on must stay until it is up
let stale = false; // the views are to follow the text

/** One step that can be undone; the views follow, when the focus is where it goes. */
function change(one: Change | Change[] | undefined, what: string, rows = false): void {
  say(one ? '' : t('{1} cannot be changed here: change it in the text.', what));
  if (one) view.dispatch({ changes: one, userEvent: 'input.form' });
  stale = true;
  if (rows) views();
  else setTimeout(follow);
}

function follow(): void {
  if (stale && !pointing) views();
}

const place = new Place();
const theDesk: Desk = {
  text: current,
  change,
  engine: () => (ready ? engine : undefined),
  us: () => us,
  theory: () => theory,
  along: () => along,
  place,
  say: (words) => say(words),
};

/** What a drag would make of the route, while it lasts. */
let ghost: string | null = null;
const askAlong = newest(
  async (words: string) => ({ words, along: await engine?.along(words) }),
  (found) => found?.along && found.words === ghost && draw(found.along, false),
);
function preview(words: string | null): void {
  ghost = words;
  if (words === null) draw(along, true);
  else if (ready) askAlong(words);
}

/** The file whose lines lie under the plan, with its units; it stays when its line is written into the case. */
let under = '';
async function lay(): Promise<void> {
  const file = writtenAt(current(), ['route', 'file']);
  if (file === undefined || !engine) return;
  const units = writtenAt(current(), ['route', 'units']) ?? '';
  const wanted = `${file} ${units}`;
  if (wanted === under) return;
  under = wanted;
  const lines = await engine.lines(file, units).catch(() => []);
  if (under === wanted) plan.lay(lines);
}

function draw(what: Along | undefined, still: boolean): void {
  if (still && (plan.dragging || strips.dragging)) return;
  plan.show(what, still);
  strips.show(what, still);
}

const word = (code: string): string => t(`verdict ${code}`);
const plan = new Plan(theDesk, preview);
const strips = new Strips(theDesk, preview);
const whatIf = new WhatIf(theDesk, word);
const variants = new Variants(theDesk, word, (doc, as) => open(doc, as, engine?.files));
const catalogue = new Catalogue(theDesk, () => page);
const equipment = new Equipment(theDesk);
const help = new Help(() => schema);
const begin = new Start({
  engine: () => theDesk.engine(),
  examples: EXAMPLES,
  drafts,
  verdict: word,
  open: (doc, as, draft) => {
    if (draft === undefined) open(doc, as);
    else void keptFiles(draft).then((files) => open(doc, as, files));
  },
  choose: () => part('file').click(),
});
part('plan').append(plan.root, strips.root);
part('whatif').append(whatIf.root);
part('variants').append(variants.root);
part('duct').append(catalogue.root);
part('equipment').append(equipment.root);
part('help').append(help.root);

const left = new Tabs(
  {
    route: part('route'),
    duct: part('duct'),
    equipment: part('equipment'),
    values: part('values'),
    text: part('editor'),
  },
  'route',
  () => views(),
);
const right = new Tabs(
  { plan: part('plan'), whatif: part('whatif'), variants: part('variants'), page: part('page'), help: part('help') },
  'plan',
  () => views(),
);

/** Makes what is shown anew out of the text; what had the focus has it again. */
function views(): void {
  stale = false;
  const at = document.activeElement?.closest<HTMLElement>('.view');
  const focus = at && at.id !== 'plan' ? document.activeElement?.getAttribute('aria-label') : null;
  if (left.shown === 'route') routeView(part('route'), theDesk);
  if (left.shown === 'values') valuesView(part('values'), theDesk, schema);
  if (left.shown === 'duct') catalogue.show();
  if (left.shown === 'equipment') equipment.show();
  if (right.shown === 'whatif') whatIf.show();
  if (right.shown === 'variants') variants.show();
  if (right.shown === 'help') help.show();
  if (focus && at)
    [...at.querySelectorAll<HTMLElement>('[aria-label]')]
      .find((one) => one.getAttribute('aria-label') === focus)
      ?.focus();
  markPlace(place.at);
}

/** The marked place in what is on the left: the row of the route's table, the line of the text. */
function markPlace(s: number | null): void {
  const piece = s === null ? undefined : along?.pieces.find((one) => s >= one.s_m && s <= one.s_m + one.length_m);
  markRoute(part('route'), piece?.listed ?? 0);
  if (left.shown === 'text') markLine(piece?.listed ?? 0);
}
place.follow(markPlace);

// ---------------------------------------------------------------------------------------------------------- the answer

function say(words: string): void {
  part('status').textContent = words;
}

/** The newest text wins: while one is being calculated the others wait, and only the last of them is. */
function ask(): void {
  const mine = ++wanted;
  part('answer').setAttribute('aria-busy', 'true'); // what stands there is of the text before
  part('remedies').replaceChildren();
  settle(false);
  setTimeout(() => {
    if (mine === wanted && !busy) void calculate();
  }, 150);
}

/** Whether the calculation is that of the text as it stands, and may be handed on. */
function settle(good: boolean): void {
  for (const id of ['save-page', 'print']) part(id, HTMLButtonElement).disabled = !good;
}

async function calculate(): Promise<void> {
  if (!engine || !ready) return;
  const mine = wanted;
  const doc = current();
  busy = true;
  try {
    const found = await engine.theory(doc);
    if (mine === wanted) await showAnswer(found, mine);
    const line = found.theory ? undefined : await engine.along(doc).catch(() => undefined);
    if (mine === wanted) {
      theory = found;
      along = line;
      part('plan').classList.remove('stale');
      draw(along, true);
    }
    // several chains have no page: their answers in words stand in its place
    const sheet = found.theory
      ? `<pre style="white-space:pre-wrap;padding:12px">${escaped(await engine.answer(doc, us))}</pre>`
      : await engine.page(doc, us, writtenAt(doc, ['job', 'language']) === undefined ? languageNow() : '');
    if (mine === wanted) {
      page = sheet;
      part('page', HTMLIFrameElement).srcdoc = sheet;
      mark();
      settle(true);
      answered();
    }
  } catch (why) {
    if (mine === wanted) showFault(why);
  }
  busy = false;
  done = mine;
  if (mine !== wanted) void calculate();
  else part('answer').setAttribute('aria-busy', 'false');
}

const escaped = (words: string): string => words.replace(/[&<>]/g, (c) => `&#${c.charCodeAt(0)};`);

/** Views of the answer once it is there. */
function answered(): void {
  if (right.shown === 'whatif') whatIf.show();
  if (right.shown === 'variants') variants.show();
  if (left.shown === 'duct') catalogue.cross();
  if (left.shown === 'equipment' && !part('equipment').contains(document.activeElement)) equipment.show();
  markPlace(place.at);
  void lay();
  void begin.draw();
}

/** A sentence of the engine without its verdict, which stands before it. */
const withoutWord = (sentence: string): string =>
  sentence.replace(/^[A-Z ]+: (.)/, (_, first: string) => first.toUpperCase());

async function showAnswer(whole: Theory, mine: number): Promise<void> {
  const { chain, one, chains } = worstChain(whole);
  // whole sentences are translated, and cut behind that: an "only if" is no sentence without its word
  const plainly = [one.verdict_forward, one.verdict_backward];
  const said = languageNumber() ? await engine?.words(plainly, languageNumber()) : plainly.map(withoutWord);
  if (mine !== wanted) return;
  const chip = part('verdict');
  chip.textContent = word(one.verdict_code);
  chip.className = one.verdict_code;
  chip.title = t(`verdict ${one.verdict_code}, help`);
  const [forward, back] = [one.largest_force_N, one.backward_largest_force_N].map((force) => quantity(force, 'N', us));
  const way = (words: string, sentence: string | undefined): HTMLElement =>
    el('p', {}, el('strong', {}, words), ` ${sentence ?? ''}`);
  part('words').replaceChildren(
    ...(chain ? [el('p', {}, t('Of {1} chains the worst: {2}.', String(chains), chain))] : []),
    way(t('Pulled forward {1} at the winch.', forward ?? ''), said?.[0]),
    way(t('Pulled back {1}.', back ?? ''), said?.[1]),
  );
  document.title = `${one.title}: ${chip.textContent}`;
  part('remedies').replaceChildren(...(chain ? [] : remedies(one)));
}

/** What theory says would do, as far as all of it are values of the text: a button writes it. What has no place of its own belongs to
 * one remedy, whatever keys it changes. */
function remedies(theory: Theory): (HTMLElement | string)[] {
  const groups = new Map<string, Remedy[]>();
  for (const one of theory.remedies ?? []) {
    const key = `${one.remedy} ${one.where}`;
    if (one.direction === 'forward') groups.set(key, [...(groups.get(key) ?? []), one]);
  }
  const found: HTMLElement[] = [];
  for (const group of groups.values()) {
    const next = ({ value, unit }: Remedy) => (unit && unit !== '1' ? `${value} ${unit}` : String(value));
    const changes = group.map((one) =>
      one.key && one.value !== null ? setValue(current(), pathOf(one.key), next(one)) : undefined,
    );
    if (changes.some((one) => !one)) continue;
    const words = group
      .map((one) => {
        const now = one.key ? writtenAt(current(), pathOf(one.key)) : undefined;
        return `${one.key}: ${next(one)}${now === undefined ? '' : ` (${t('now {1}', now)})`}`;
      })
      .join(', ');
    const one = button(
      words,
      `${t('Writes it into the case, which is then:')} ${word(group[0]?.verdict_code ?? '')}`,
      () => change(changes as Change[], words),
    );
    one.removeAttribute('aria-label'); // its words say it
    found.push(one);
  }
  return found.length ? [t('What would make it safe:'), ...found] : [];
}

function showFault(why: unknown): void {
  const fault: Fault | undefined = why instanceof EngineError ? why.fault : undefined;
  const chip = part('verdict');
  chip.textContent = t('NOT A CASE YET');
  chip.className = 'fault';
  chip.title = '';
  part('words').textContent = fault?.message.replace(/^case\.yaml:(\d+)/, t('line {1}', '$1')) ?? String(why);
  const missing = namedBy(current()).filter((place) => !engine?.files.has(place));
  part('remedies').replaceChildren(
    ...missing.map((place) => button(t('Choose the file {1}', baseOf(place)), '', () => part('file').click())),
    ...(fault?.line && left.shown !== 'text'
      ? [button(t('Show line {1}', String(fault.line)), '', toLine(fault.line))]
      : []),
  );
  page = '';
  part('page', HTMLIFrameElement).srcdoc = '';
  document.title = 'hawser desk';
  mark(fault);
  part('plan').classList.add('stale'); // it is that of the last text that was a case, with the values of this one
  draw(along, true);
}

/** To a line of the text. */
const toLine = (line: number) => (): void => {
  left.show('text');
  view.dispatch({
    selection: { anchor: view.state.doc.line(Math.min(line, view.state.doc.lines)).to },
    scrollIntoView: true,
  });
  view.focus();
};

/** The line of the route's piece, from 1 on; 0: none. */
function markLine(listed: number): void {
  const path = ['pieces', 'points'].map((kind) => ['route', kind, listed - 1]);
  const node = listed ? path.map((one) => nodeAt(parsed(current()), one)).find((one) => one?.range) : undefined;
  showLine(view, node?.range && node.range[0] <= view.state.doc.length ? node.range[0] : -1);
}

/** The engine's message at its line. */
function mark(fault?: Fault): void {
  const marks: Diagnostic[] = [];
  if (fault && fault.line > 0 && fault.line <= view.state.doc.lines) {
    const line = view.state.doc.line(fault.line);
    marks.push({ from: line.from, to: line.to, severity: 'error', message: fault.message });
  }
  view.dispatch(setDiagnostics(view.state, marks));
}

// --------------------------------------------------------------------------------------------------------------- files

function download(as: string, content: BlobPart, type: string): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([content], { type }));
  link.download = as;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

/** A model of the tunnel: put beside the case, as GLB, and taken into its section `environment`. */
async function openModel(name: string, bytes: Uint8Array<ArrayBuffer>): Promise<void> {
  const told = unitOf(name);
  if (!told) return;
  let file = name;
  try {
    if (CONVERTED.test(name)) {
      say(t('Converting {1}.', name));
      const { glb, triangles, points, notes } = await converted(name, bytes, told);
      file = name.replace(/\.\w+$/, '.glb');
      bytes = glb;
      say([`${file}: ${triangles + points}`, ...notes].join('; '));
    }
    const places = placesFor(current(), file).map((place) => [place, bytes] as const);
    await hold(new Map([...(engine?.files ?? []), ...places]));
    const there = nodeAt(parsed(current()), ['environment']) !== undefined;
    if (!there) change(putSection(current(), 'environment', `environment:\n${item(file, told)}`), t('Environment'));
    else say(t('The case has an environment already: add {1} to it.', file));
  } catch (why) {
    say(`${name}: ${messageOf(why)}`);
  }
}

/** Files that were chosen together: a case with its own, as an archive or one by one; or those of the case on the desk; or a new route. */
async function openFiles(chosen: Iterable<File>): Promise<void> {
  begin.close();
  const all = await Promise.all(
    [...chosen].map(async (file) => ({ name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) })),
  );
  const placed = (text: string, files: typeof all): Files =>
    new Map(files.flatMap(({ name, bytes }) => placesFor(text, name).map((place) => [place, bytes] as const)));
  const archive = all.find((one) => /\.zip$/i.test(one.name));
  if (archive) {
    const set = unpacked(archive.bytes);
    if (!set) throw new Error(t('{1} has no case in it.', archive.name));
    open(set.text, set.name, set.files);
    return;
  }
  const asked = (name: string): boolean => namedBy(current()).some((place) => place.endsWith(`/${name}`));
  const main = mainOf(all.filter((one) => !asked(one.name)));
  if (main) {
    open(
      main.text,
      main.name,
      placed(
        main.text,
        all.filter((one) => one.name !== main.name),
      ),
    );
    return;
  }
  const shape = all.find((one) => SHAPES.test(one.name));
  if (shape)
    throw new Error(
      t('The desk reads no shapefiles such as {1}. Save the lines as GeoJSON, for example by QGIS.', shape.name),
    );
  const isModel = (name: string): boolean =>
    !asked(name) && (READ.test(name) || (CONVERTED.test(name) && !ROUTES.test(name)));
  const lines = all.filter((one) => !isModel(one.name));
  const other = lines.find((one) => !asked(one.name) && !ROUTES.test(one.name) && !CASES.test(one.name));
  if (other) throw new Error(t('{1} is neither a case nor a route.', other.name));
  await hold(new Map([...(engine?.files ?? []), ...placed(current(), lines)]));
  for (const { name: file, bytes } of lines)
    if (asked(file)) say(t('{1}: the case names it.', file));
    else if (!CONVERTED.test(file)) await route(file);
    else await route(file).catch(() => openModel(file, bytes)); // an IFC without an alignment is a model
  for (const model of all.filter((one) => isModel(one.name))) await openModel(model.name, model.bytes);
}

/** The line of a file beside the case becomes its route. */
async function route(file: string): Promise<void> {
  const lines = (await engine?.route(file)) ?? [];
  const good = lines.filter((line) => !line.problem);
  const only = good.length > 1 ? `, name: ${JSON.stringify(good[0]?.name ?? '')}` : '';
  change(putSection(current(), 'route', `route: {file: ${JSON.stringify(file)}${only}}`), t('Route'));
  const kinds = good.map((line) => `${line.name || t('a line')} (${line.length_m.toFixed(1)} m)`).join(', ');
  say(`${file}: ${kinds}. ${t('It is kept and saved with the case.')}`);
}

const opened = (chosen: Iterable<File>): void => void openFiles(chosen).catch((why: unknown) => say(messageOf(why)));

/** The case as a file; with the files that it names, if it names any, as one archive. */
function save(): void {
  const words = current().replaceAll('\n', eol);
  const files = engine?.files ?? new Map();
  const archive = packed(name, words, files);
  if (archive) download(`${name.replace(CASES, '')}.zip`, archive, 'application/zip');
  else download(name, words, 'text/yaml');
  const missing = namedBy(words).filter((place) => !files.has(place));
  say(missing.length ? t('{1} is not in it: it was not opened here.', missing.map(baseOf).join(', ')) : '');
  saved = current();
  title();
}

const baseOf = (place: string): string => place.slice(place.lastIndexOf('/') + 1);

// ---------------------------------------------------------------------------------------------------------- the screen

function wire(): void {
  simulation = new Simulation({
    engine: () => engine,
    current,
    name: () => name,
    us: () => us,
    force: (newtons) => quantity(newtons, 'N', us),
    download,
  });
  part('new').addEventListener('click', () => begin.show());
  const input = part('file', HTMLInputElement);
  part('open').addEventListener('click', () => input.click());
  input.addEventListener('change', () => {
    opened([...(input.files ?? [])]);
    input.value = '';
  });
  part('save').addEventListener('click', save);
  part('save-page').addEventListener('click', () =>
    download(name.replace(/\.ya?ml$/, '') + '-calculation.html', part('page', HTMLIFrameElement).srcdoc, 'text/html'),
  );
  part('print').addEventListener('click', () => part('page', HTMLIFrameElement).contentWindow?.print());
  part('units').addEventListener('change', () => {
    us = part('units', HTMLSelectElement).value === 'us';
    remember();
    views();
    draw(along, true);
    ask();
  });
  part('language').addEventListener('change', () => {
    chosen = part('language', HTMLSelectElement).value as Language;
    location.hash = ''; // what is chosen now wins over the address
    remember();
    speak(chosen);
    ask();
  });
  part('wipe').addEventListener('click', () => {
    try {
      localStorage.removeItem(draftKey());
      void forgetFiles(draftKey());
      forgetVariants();
      say(t('The draft and the variants that this browser kept are gone.'));
    } catch {
      say(t('This browser keeps no drafts.'));
    }
  });
  document.addEventListener('pointerdown', () => (pointing = true), true);
  document.addEventListener('pointerup', () => {
    pointing = false;
    setTimeout(follow);
  });
  document.addEventListener('keydown', (event) => {
    const place = event.target as HTMLElement;
    const typing = place instanceof HTMLInputElement && place.value !== place.defaultValue;
    if (!(event.ctrlKey || event.metaKey) || typing || place.closest('#editor')) return;
    const back = event.key === 'z' && !event.shiftKey;
    if (!back && event.key !== 'y' && event.key !== 'Z') return;
    event.preventDefault();
    (back ? undo : redo)(view);
    views();
  });
  document.addEventListener('dragover', (event) => event.preventDefault());
  document.addEventListener(
    'drop',
    (event) => {
      event.preventDefault();
      event.stopPropagation(); // the editor would insert the file's text
      opened([...(event.dataTransfer?.files ?? [])]);
    },
    true,
  );
  window.addEventListener('beforeunload', (event) => {
    if (current() !== saved) event.preventDefault();
  });
}

let chosen: Language | undefined; // by the reader; undefined: the case or the browser says it

const isLanguage = (tag: string | undefined): tag is Language => LANGUAGES.some((one) => one === tag);

/** What was chosen, for the next time. */
function remember(): void {
  try {
    localStorage.setItem(SETTINGS, JSON.stringify({ us, language: chosen }));
  } catch {
    // a browser that keeps nothing for pages from disk
  }
}

/** The address (#de), what was chosen before, the case's `job.language`, the browser's. */
function languageOf(): Language {
  const wanted = [
    /[#&](?:lang=)?(en|zh|de)\b/.exec(location.hash)?.[1],
    chosen,
    writtenAt(current(), ['job', 'language']),
    navigator.language.slice(0, 2),
  ];
  return wanted.find(isLanguage) ?? 'en';
}

function settings(): void {
  try {
    const kept = JSON.parse(localStorage.getItem(SETTINGS) ?? '{}') as { us?: boolean; language?: string };
    us = kept.us === true;
    chosen = isLanguage(kept.language) ? kept.language : undefined;
  } catch {
    // as above
  }
  part('units', HTMLSelectElement).value = us ? 'us' : 'si';
}

/** Everything on the desk in a language. */
function speak(language: Language): void {
  setLanguage(language);
  translate(document);
  part('language', HTMLSelectElement).value = language;
  part('page').title = t('The calculation');
  part('wipe').title = t('What you write is kept in this browser until you do this');
  begin.words();
  view.contentDOM.setAttribute('aria-label', t('The case as text'));
  simulation?.words();
  say('');
  views();
  draw(along, true);
}

/** What the browser has kept, by its keys. */
function drafts(): Map<string, Draft> {
  const found = new Map<string, Draft>();
  try {
    for (const key of Object.keys(localStorage))
      if (key === DRAFT || key.startsWith(`${DRAFT}:`))
        found.set(key, JSON.parse(localStorage.getItem(key) ?? '') as Draft);
  } catch {
    // as above
  }
  return found;
}

async function start(): Promise<void> {
  wire();
  settings();
  given = JSON.parse(text('case')) as typeof given; // `hawser desk CASE` has put it there
  const before = drafts().get(draftKey());
  const first = given ?? { name: 'case.yaml', text: ductText };
  take(first.text, first.name);
  const later = before?.text && before.text !== current();
  let drafted = !given && !!before;
  if (later && (!given || confirm(t('This browser has a draft of {1} that differs. Go on with it?', first.name)))) {
    take(before.text, before.name);
    saved = ''; // nobody has saved it
    drafted = true;
    title();
  }
  speak(languageOf());
  if (!given && !before) begin.show();
  say(t('The engine is starting.'));
  engine = new Engine(workerOf(`${text('glue')}\n${text('worker')}`));
  await engine.start(await inflated(text('engine')));
  const own = Object.entries(given?.files ?? {}).map(([file, bytes]) => [placeOf(file), bytesOf(bytes)] as const);
  await engine.hold(new Map([...own, ...(drafted ? await keptFiles(draftKey()) : [])]));
  say('');
  ready = true;
  schema = JSON.parse(await engine.call('schema')) as Schema;
  complete = completions(schema);
  views();
  ask();
}

/** For tests. */
Object.assign(window, {
  hawserDesk: {
    current,
    idle: () => !busy && wanted === done,
    withoutRow,
    along: () => along,
    open: (doc: string) => {
      view.setState(state(doc));
      ask();
    },
    type: (where: (text: string) => [number, number, string]) => {
      const [from, to, insert] = where(current());
      view.dispatch({ changes: { from, to, insert } });
      views();
    },
    cursor: (line: number) => {
      left.show('text');
      view.dispatch({ selection: { anchor: view.state.doc.line(line).to } });
      view.focus();
    },
    theory: (doc: string) => engine?.call('theory', doc, 'all'),
    hold: (files: Record<string, string>) =>
      hold(new Map(Object.entries(files).map(([name, words]) => [placeOf(name), new TextEncoder().encode(words)]))),
  },
});

start().catch((why: unknown) => say(`${t('The engine does not start.')} ${String(why)}`));

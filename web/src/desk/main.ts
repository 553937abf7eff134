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
import ductText from '../../../docs/tutorial/duct.yaml';
import tunnelText from '../../../docs/tutorial/tunnel.yaml';
import plannerText from '../../../cases/theory/planner.yaml';
import threeText from '../../../cases/three-in-a-duct.yaml';
import rollersText from '../../../cases/huangjiahu.yaml';
import limitsText from '../../../cases/limits.yaml';
import { Engine, EngineError, inflated, workerOf, type Fault, type Remedy, type Theory } from './engine';
import { completions, type Schema } from './complete';
import { button, routeView, type Editing } from './route';
import { Simulation } from './simulate';
import { filesOf, pathOf, putSection, setValue, type Change } from './splice';
import { valuesView } from './values';

const EXAMPLES: [string, string][] = [
  ['A cable in a duct', ductText],
  ['Three cables in a duct', threeText],
  ['Ducts with a pit between', plannerText],
  ['A tunnel with rollers', tunnelText],
  ['Rollers and their loads', limitsText],
  ['The tunnel of the paper', rollersText],
];
const DRAFT = 'hawser-desk-draft';
const ROUTES = /\.(csv|tsv|xlsx|ods|dxf|xml|landxml|ifc|gpx|kml|kmz|geojson|geojsonl|shp)$/i;

const part = <T extends HTMLElement = HTMLElement>(id: string): T => document.getElementById(id) as T;
const text = (id: string): string => part(id).textContent ?? '';

let us = false;
let saved = '';
let eol = '\n'; // how the lines of the case's file end
let given: { name: string; text: string } | null = null;
let name = 'case.yaml';
const TABS = ['text', 'route', 'values'] as const;
let shown: (typeof TABS)[number] = 'text';

// ------------------------------------------------------------------------------------------------------------ the text

let engine: Engine | undefined;
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
      EditorView.lineWrapping,
      EditorView.contentAttributes.of({ 'aria-label': 'The case as text' }),
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
  view.setState(state(doc));
  saved = current();
  title();
  views();
  ask();
}

function open(doc: string, as: string): void {
  if (current() !== saved && !confirm('The case has changes that are not saved. Leave them?')) return;
  say('');
  take(doc, as);
  keep();
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
  say(one ? '' : `${what} cannot be changed here: change it in the text.`);
  if (one) view.dispatch({ changes: one, userEvent: 'input.form' });
  stale = true;
  if (rows) views();
  else setTimeout(follow);
}

function follow(): void {
  if (stale && !pointing) views();
}

const editing: Editing = { text: current, change };

function views(): void {
  stale = false;
  const focus = document.activeElement?.closest('.view') ? document.activeElement.getAttribute('aria-label') : null;
  for (const tab of TABS) {
    part(tab === 'text' ? 'editor' : tab).hidden = shown !== tab;
    part(`tab-${tab}`).setAttribute('aria-selected', String(shown === tab));
    part(`tab-${tab}`).tabIndex = shown === tab ? 0 : -1;
  }
  if (shown === 'route') routeView(part('route'), editing);
  if (shown === 'values') valuesView(part('values'), editing);
  if (focus && shown !== 'text')
    [...part(shown).querySelectorAll<HTMLElement>('[aria-label]')]
      .find((one) => one.getAttribute('aria-label') === focus)
      ?.focus();
}

function show(tab: (typeof TABS)[number]): void {
  shown = tab;
  views();
  part(`tab-${tab}`).focus();
}

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
  for (const id of ['save-page', 'print']) part<HTMLButtonElement>(id).disabled = !good;
}

async function calculate(): Promise<void> {
  if (!engine || !ready) return;
  const mine = wanted;
  const doc = current();
  busy = true;
  try {
    const theory = await engine.theory(doc);
    if (mine === wanted) showAnswer(theory);
    // several chains have no page: their answers in words stand in its place
    const page = theory.theory
      ? `<pre style="white-space:pre-wrap;padding:12px">${escaped(await engine.answer(doc, us))}</pre>`
      : await engine.page(doc, us);
    if (mine === wanted) {
      part<HTMLIFrameElement>('page').srcdoc = page;
      mark();
      settle(true);
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

/** A force as people read it. */
function force(newtons: number): string {
  const [value, unit] = us
    ? [newtons / 4.4482216152605, 'lbf']
    : newtons < 1000
      ? [newtons, 'N']
      : [newtons / 1000, 'kN'];
  return `${value.toPrecision(4)} ${unit}`;
}

const word = (verdict: string): string => verdict.split(':')[0] ?? '';

/** From the best verdict to the worst. */
const RANKS = ['safe', 'safe_if', 'not_judged', 'not_trusted', 'not_safe'];

function showAnswer(whole: Theory): void {
  const chains = Object.entries(whole.theory ?? { '': whole });
  const rank = (one: Theory): number => RANKS.indexOf(one.verdict_code);
  const [chain, theory] = chains.reduce((worst, one) => (rank(one[1]) > rank(worst[1]) ? one : worst));
  const chip = part('verdict');
  chip.textContent = word(theory.verdict_forward);
  chip.className = theory.verdict_code;
  const lines = [
    ...(chain ? [`Of ${chains.length} chains the worst: ${chain}.`] : []),
    `Pulled forward ${force(theory.largest_force_N)} at the winch. ${theory.verdict_forward}`,
    `Pulled backward ${force(theory.backward_largest_force_N)}. ${word(theory.verdict_backward)}`,
  ];
  part('words').textContent = lines.join('\n');
  document.title = `${theory.title}: ${chip.textContent}`;
  part('remedies').replaceChildren(...(chain ? [] : remedies(theory)));
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
    const words = group.map((one) => `${one.key}: ${next(one)}`).join(', ');
    const then = group[0]?.verdict_code.replaceAll('_', ' ') ?? '';
    const one = button(words, `Writes it into the case, which is ${then} then`, () =>
      change(changes as Change[], words),
    );
    one.removeAttribute('aria-label'); // its words say it
    found.push(one);
  }
  return found.length ? ['What would do: ', ...found] : [];
}

function showFault(why: unknown): void {
  const fault: Fault | undefined = why instanceof EngineError ? why.fault : undefined;
  const chip = part('verdict');
  chip.textContent = 'NOT A CASE YET';
  chip.className = 'fault';
  part('words').textContent = fault?.message.replace(/^case\.yaml:(\d+)/, 'line $1') ?? String(why);
  part('remedies').replaceChildren();
  part<HTMLIFrameElement>('page').srcdoc = '';
  document.title = 'hawser desk';
  mark(fault);
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

function download(as: string, content: string, type: string): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([content], { type }));
  link.download = as;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

async function openFile(file: File): Promise<void> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  const named = filesOf(current()).filter((path) => path.split('/').pop() === file.name);
  if (named.length) {
    for (const path of named) await engine?.put(path, bytes);
    say(`${file.name}: the case names it.`);
    ask();
    return;
  }
  if (!ROUTES.test(file.name)) {
    open(new TextDecoder().decode(bytes), file.name);
    return;
  }
  await engine?.put(file.name, bytes);
  try {
    const lines = (await engine?.route(file.name)) ?? [];
    const good = lines.filter((line) => !line.problem);
    const only = good.length > 1 ? `, name: ${JSON.stringify(good[0]?.name ?? '')}` : '';
    change(putSection(current(), 'route', `route: {file: ${JSON.stringify(file.name)}${only}}`), 'The route');
    const kinds = good.map((line) => `${line.name || 'a line'} (${line.length_m.toFixed(1)} m)`).join(', ');
    say(`${file.name}: ${kinds}. Keep the file beside the case: the case refers to it.`);
  } catch (why) {
    say(why instanceof EngineError ? why.fault.message : String(why));
  }
}

// ---------------------------------------------------------------------------------------------------------- the screen

function wire(): void {
  new Simulation({
    engine: () => engine,
    current,
    name: () => name,
    us: () => us,
    t: (english, ...parts) => english.replace(/\{(\d)\}/g, (_, i: string) => parts[Number(i) - 1] ?? ''),
    force,
    download,
  });
  const menu = part<HTMLSelectElement>('examples');
  EXAMPLES.forEach(([label], i) => menu.add(new Option(label, String(i))));
  menu.addEventListener('change', () => {
    const example = EXAMPLES[Number(menu.value)];
    menu.value = '';
    if (example) open(example[1], 'case.yaml');
  });
  const input = part<HTMLInputElement>('file');
  part('open').addEventListener('click', () => input.click());
  input.addEventListener('change', () => {
    for (const file of input.files ?? []) void openFile(file);
    input.value = '';
  });
  part('save').addEventListener('click', () => {
    download(name, current().replaceAll('\n', eol), 'text/yaml');
    saved = current();
    title();
  });
  part('save-page').addEventListener('click', () =>
    download(name.replace(/\.ya?ml$/, '') + '-calculation.html', part<HTMLIFrameElement>('page').srcdoc, 'text/html'),
  );
  part('print').addEventListener('click', () => part<HTMLIFrameElement>('page').contentWindow?.print());
  part('units').addEventListener('change', () => {
    us = part<HTMLSelectElement>('units').value === 'us';
    ask();
  });
  for (const tab of TABS) part(`tab-${tab}`).addEventListener('click', () => show(tab));
  part('tab-text').parentElement?.addEventListener('keydown', (event) => {
    const step = { ArrowRight: 1, ArrowLeft: TABS.length - 1 }[event.key];
    if (step) show(TABS[(TABS.indexOf(shown) + step) % TABS.length] ?? 'text');
  });
  part('wipe').addEventListener('click', () => {
    try {
      localStorage.removeItem(draftKey());
      say('The draft that this browser kept is gone.');
    } catch {
      say('This browser keeps no drafts.');
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
      for (const file of event.dataTransfer?.files ?? []) void openFile(file);
    },
    true,
  );
  window.addEventListener('beforeunload', (event) => {
    if (current() !== saved) event.preventDefault();
  });
}

function draft(): { name: string; text: string } | undefined {
  try {
    return JSON.parse(localStorage.getItem(draftKey()) ?? 'null') ?? undefined;
  } catch {
    return undefined;
  }
}

async function start(): Promise<void> {
  wire();
  given = JSON.parse(text('case')) as typeof given; // `hawser desk CASE` has put it there
  const before = draft();
  const first = given ?? { name: 'case.yaml', text: ductText };
  take(first.text, first.name);
  const later = before?.text && before.text !== current();
  if (later && (!given || confirm(`This browser has a draft of ${first.name} that differs. Go on with it?`))) {
    take(before.text, before.name);
    saved = ''; // nobody has saved it
    title();
  }
  say('The engine is starting.');
  engine = new Engine(workerOf(`${text('glue')}\n${text('worker')}`));
  await engine.start(await inflated(text('engine')));
  say('');
  ready = true;
  complete = completions(JSON.parse(await engine.call('schema')) as Schema);
  ask();
}

/** For tests. */
Object.assign(window, {
  hawserDesk: {
    current,
    idle: () => !busy && wanted === done,
    open: (doc: string) => {
      view.setState(state(doc));
      ask();
    },
    cursor: (line: number) => {
      view.dispatch({ selection: { anchor: view.state.doc.line(line).to } });
      view.focus();
    },
    theory: (doc: string) => engine?.call('theory', doc, 'all'),
  },
});

start().catch((why: unknown) => say(`The engine does not start: ${String(why)}`));

/** The desk: a case's text on the left, what theory says of it on the right, always of the text as it stands. */
import { basicSetup } from 'codemirror';
import { autocompletion } from '@codemirror/autocomplete';
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
import { Engine, EngineError, inflated, workerOf, type Fault, type Theory } from './engine';
import { completions, type Schema } from './complete';
import { button, routeView, type Editing } from './route';
import { pathOf, setValue, type Change } from './splice';
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
const ROUTES = /\.(csv|tsv|xlsx|ods|dxf|xml|landxml|ifc|gpx|kml|kmz|geojson|geojsonl|json|shp)$/i;

const part = <T extends HTMLElement = HTMLElement>(id: string): T => document.getElementById(id) as T;
const text = (id: string): string => part(id).textContent ?? '';

let us = false;
let saved = '';
let name = 'case.yaml';
let shown: 'text' | 'route' | 'values' = 'text';

// ------------------------------------------------------------------------------------------------------------ the text

let engine: Engine | undefined;
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

function open(doc: string, as: string): void {
  if (current() !== saved && !confirm('The case has changes that are not saved. Leave them?')) return;
  name = as;
  saved = doc;
  view.setState(state(doc));
  keep();
  views();
  ask();
}

function keep(): void {
  part('name').textContent = name + (current() === saved ? '' : ' *');
  try {
    localStorage.setItem(DRAFT, JSON.stringify({ name, text: current() }));
  } catch {
    // a browser that keeps nothing for pages from disk: there is no draft then
  }
}

/** One step that can be undone; the views follow. */
function change(one: Change | undefined, what: string): void {
  if (!one) {
    say(`${what} cannot be changed here: change it in the text.`);
    views();
    return;
  }
  view.dispatch({ changes: one, userEvent: 'input.form' });
  views();
}

const editing: Editing = { text: current, change };

function views(): void {
  for (const tab of ['text', 'route', 'values'] as const) {
    part(tab === 'text' ? 'editor' : tab).hidden = shown !== tab;
    part(`tab-${tab}`).setAttribute('aria-selected', String(shown === tab));
  }
  if (shown === 'route') routeView(part('route'), editing);
  if (shown === 'values') valuesView(part('values'), editing);
}

// ---------------------------------------------------------------------------------------------------------- the answer

function say(words: string): void {
  part('status').textContent = words;
}

/** The newest text wins: while one is being calculated the others wait, and only the last of them is. */
function ask(): void {
  const mine = ++wanted;
  setTimeout(() => {
    if (mine === wanted && !busy) void calculate();
  }, 150);
}

async function calculate(): Promise<void> {
  if (!engine) return;
  const mine = wanted;
  const doc = current();
  busy = true;
  part('answer').setAttribute('aria-busy', 'true');
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

function showAnswer(whole: Theory): void {
  const chains = Object.values(whole.theory ?? { only: whole });
  const theory = chains.find((one) => one.verdict_code !== 'safe') ?? chains[0] ?? whole;
  const chip = part('verdict');
  chip.textContent = word(theory.verdict_forward);
  chip.className = theory.verdict_code;
  const lines = [
    `Pulled forward ${force(theory.largest_force_N)} at the winch. ${theory.verdict_forward}`,
    `Pulled backward ${force(theory.backward_largest_force_N)}. ${word(theory.verdict_backward)}`,
  ];
  part('words').textContent = lines.join('\n');
  document.title = `${theory.title}: ${chip.textContent}`;
  part('remedies').replaceChildren(...remedies(theory));
}

/** What theory says would do, as far as it is a value of the text: a button writes it. */
function remedies(theory: Theory): (HTMLElement | string)[] {
  const found: HTMLElement[] = [];
  for (const { direction, key, value, unit, verdict_code } of theory.remedies ?? []) {
    if (direction !== 'forward' || !key || value === null) continue;
    const next = unit && unit !== '1' ? `${value} ${unit}` : String(value);
    if (!setValue(current(), pathOf(key), next)) continue;
    const title = `Writes it into the case, which is ${verdict_code.replaceAll('_', ' ')} then`;
    found.push(button(`${key}: ${next}`, title, () => change(setValue(current(), pathOf(key), next), key)));
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
  if (!ROUTES.test(file.name)) {
    open(await file.text(), file.name);
    return;
  }
  await engine?.put(file.name, new Uint8Array(await file.arrayBuffer()));
  if (current().includes(file.name)) {
    ask(); // the case refers to it already
    return;
  }
  try {
    const lines = (await engine?.route(file.name)) ?? [];
    const good = lines.filter((line) => !line.problem);
    const only = good.length > 1 ? `, name: ${JSON.stringify(good[0]?.name ?? '')}` : '';
    takeRoute(`route: {file: ${JSON.stringify(file.name)}${only}}`);
    const kinds = good.map((line) => `${line.name || 'a line'} (${line.length_m.toFixed(1)} m)`).join(', ');
    say(`${file.name}: ${kinds}. Keep the file beside the case: the case refers to it.`);
  } catch (why) {
    say(why instanceof EngineError ? why.fault.message : String(why));
  }
}

/** Puts the section in place of the one that is there. */
function takeRoute(section: string): void {
  const doc = current();
  const begin = /^route:/m.exec(doc)?.index;
  if (begin === undefined) {
    change({ from: doc.length, to: doc.length, insert: `${doc.endsWith('\n') ? '' : '\n'}${section}\n` }, 'the route');
    return;
  }
  const rest = doc.slice(begin + 6);
  const next = /^[^\s#-]/m.exec(rest)?.index;
  const end = next === undefined ? doc.length : begin + 6 + next;
  change({ from: begin, to: end, insert: `${section}\n\n` }, 'the route');
}

// ---------------------------------------------------------------------------------------------------------- the screen

function wire(): void {
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
    download(name, current(), 'text/yaml');
    saved = current();
    keep();
  });
  part('save-page').addEventListener('click', () =>
    download(name.replace(/\.ya?ml$/, '') + '-calculation.html', part<HTMLIFrameElement>('page').srcdoc, 'text/html'),
  );
  part('print').addEventListener('click', () => part<HTMLIFrameElement>('page').contentWindow?.print());
  part('units').addEventListener('change', () => {
    us = part<HTMLSelectElement>('units').value === 'us';
    ask();
  });
  for (const tab of ['text', 'route', 'values'] as const)
    part(`tab-${tab}`).addEventListener('click', () => {
      shown = tab;
      views();
    });
  part('wipe').addEventListener('click', () => {
    localStorage.removeItem(DRAFT);
    say('The draft that this browser kept is gone.');
  });
  document.addEventListener('dragover', (event) => event.preventDefault());
  document.addEventListener('drop', (event) => {
    event.preventDefault();
    for (const file of event.dataTransfer?.files ?? []) void openFile(file);
  });
  window.addEventListener('beforeunload', (event) => {
    if (current() !== saved) event.preventDefault();
  });
}

function draft(): { name: string; text: string } | undefined {
  try {
    return JSON.parse(localStorage.getItem(DRAFT) ?? 'null') ?? undefined;
  } catch {
    return undefined;
  }
}

async function start(): Promise<void> {
  wire();
  const given = JSON.parse(text('case')) as { name: string; text: string } | null; // `hawser desk CASE` has put it there
  const before = given ? undefined : draft();
  const first = given ?? (before?.text ? before : { name: 'case.yaml', text: ductText });
  name = first.name;
  saved = before?.text ? '' : first.text;
  view.setState(state(first.text));
  keep();
  views();
  say('The engine is starting.');
  engine = new Engine(workerOf(`${text('glue')}\n${text('worker')}`));
  await engine.start(await inflated(text('engine')));
  say('');
  complete = completions(JSON.parse(await engine.call('schema')) as Schema);
  wanted++;
  await calculate();
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

// The answer first: the verdict, where it is tightest, and what to change.
import type { Context } from '../context';
import { el, named } from '../dom';
import type { Limit } from '../data';
import { extent } from '../figure/align';
import { inWords, judged, limitUnit, numbers, remedyOf, standing, texts, type Standing } from '../run';
import { sentenceText, show } from '../units';
import { sign } from './parts';

const WORD: Record<Standing, string> = {
  safe: 'SAFE',
  conditional: 'SAFE ONLY IF',
  unsafe: 'NOT SAFE',
  untrusted: 'NOT TRUSTED',
  unjudged: 'NOT JUDGED',
};

/** Limits whose value has to be at least the bound; of all others it has to be at most that. */
const AT_LEAST = new Set(['bend_radius', 'rope_bend', 'clearance', 'clearance_environment']);

function sentence(limit: Limit, context: Context): HTMLElement {
  const { units } = context;
  const unit = limitUnit(limit);
  const margin = limit.margin ?? 0;
  const rest = margin < 0 ? `${show(-100 * margin, '%', units, 3)} over` : `${show(100 * margin, '%', units, 3)} left`;
  const bound = AT_LEAST.has(limit.name) ? 'at least ' : '';
  return el(
    'p',
    {},
    el('strong', {}, inWords(limit.name)),
    ': ',
    el('strong', {}, show(limit.value, unit, units)),
    limit.where ? ' at ' : '',
    limit.where ? named(sentenceText(limit.where, units)) : null,
    `. Allowed: ${bound}${show(limit.limit, unit, units)}; `,
    el('strong', {}, rest),
    '.',
  );
}

/** Without a limit that was judged: where the tension is largest. */
function largestTension(context: Context): HTMLElement {
  const { run, units } = context;
  const place = run.envelope?.place;
  const columns = place?.tension_max_N
    ? { s: place.s_m, tension: place.tension_max_N, names: [] as string[] }
    : {
        s: numbers(run.stations, 's_m') ?? [],
        tension: numbers(run.stations, 'peak_N') ?? [],
        names: texts(run.stations, 'name'),
      };
  const largest = extent(columns.tension)?.[1];
  if (largest === undefined) return el('p', {}, 'Where the tension is largest is not known.');
  const index = columns.tension.indexOf(largest);
  const name = columns.names[index];
  return el(
    'p',
    {},
    el('strong', {}, 'Tension'),
    ' is largest at ',
    el('strong', {}, show(columns.s[index], 'm', units)),
    name ? ' (' : '',
    name ? named(name) : null,
    name ? ')' : '',
    ' along the route: ',
    el('strong', {}, show(largest, 'N', units)),
    '. No limit was judged.',
  );
}

function tightest(context: Context): HTMLElement[] {
  const limits = judged(context.run);
  const broken = limits.filter((limit) => limit.ok === false);
  const shown = broken.length > 0 ? broken : limits.slice(0, 1);
  return shown.length > 0 ? shown.map((limit) => sentence(limit, context)) : [largestTension(context)];
}

const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

/** The remedies as the program words them: what keeps several limits together in one sentence, of the run, or of each
 * limit. */
function brokenRemedies(context: Context): HTMLElement[] {
  const remedies = context.run.summary.remedies ?? [];
  const together = remedies.flatMap((remedy) =>
    typeof remedy !== 'string' && remedy.limit === 'all' ? [remedy.text] : [],
  );
  const sentences = remedies.flatMap((remedy) =>
    typeof remedy === 'string' ? [remedy] : remedy.limit === 'all' ? [] : [remedy.text],
  );
  if (together.length > 0)
    sentences.unshift(
      `${together.join(' and ')} would do, computed by theory with this run's figures: run the case again with it`,
    );
  if (sentences.length > 0)
    return sentences.map((sentence) => el('p', {}, named(`${capital(sentenceText(sentence, context.units))}.`)));
  const broken = judged(context.run).filter((limit) => limit.ok === false);
  return broken.map((limit) => {
    const rest =
      sentenceText(remedyOf(limit), context.units) ||
      `its figures alone do not tell what to change; the limit is from: ${limit.source}`;
    return el('p', {}, el('strong', {}, inWords(limit.name)), ': ', named(rest), '.');
  });
}

function changes(context: Context): HTMLElement[] {
  const { run } = context;
  const summary = run.summary;
  switch (standing(run)) {
    case 'untrusted': {
      const failed = (summary.trust ?? []).filter((condition) => condition.holds === false);
      const list = failed.map((condition) =>
        el(
          'li',
          {},
          el('strong', {}, inWords(condition.name)),
          ': ',
          named(sentenceText(condition.remedy, context.units)),
        ),
      );
      const first = el('p', {}, 'Make the figures trustworthy first; until then no margin on this page counts.');
      return list.length > 0 ? [first, el('ul', {}, ...list)] : [first];
    }
    case 'unsafe':
      return [
        ...brokenRemedies(context),
        el('p', { class: 'detail' }, 'A remedy is calculated from the figures of this run: compute again with it.'),
      ];
    case 'conditional': {
      const bounds = (summary.limits ?? []).filter((limit) =>
        [limit.friction_most, limit.friction_least, limit.friction_at_rest_most, limit.back_tension_most_N].some(
          (bound) => typeof bound === 'number',
        ),
      );
      const list = bounds.map((limit) =>
        el(
          'li',
          {},
          el('strong', {}, inWords(limit.name)),
          `: depends on ${limit.assumed}, which the case does not give`,
        ),
      );
      return [
        el('p', {}, 'Give or measure what is assumed, or change the pull until these limits hold:'),
        el('ul', {}, ...list),
      ];
    }
    case 'safe': {
      const open = (summary.limits ?? []).filter((limit) => limit.ok === null);
      const names = open.map((limit) => inWords(limit.name).toLowerCase()).join(', ');
      return [
        el('p', {}, 'Nothing has to change: every limit that was judged holds.'),
        ...(open.length > 0
          ? [el('p', { class: 'detail' }, `Not judged: ${names}. The table of limits says what is missing.`)]
          : []),
      ];
    }
    default: {
      const open = (summary.limits ?? []).filter((limit) => limit.ok === null);
      if (open.length === 0) {
        return [el('p', {}, 'Say what the cable may bear: give the case a section “limits”, and compute again.')];
      }
      const list = open.map((limit) =>
        el('li', {}, el('strong', {}, inWords(limit.name)), ': ', named(sentenceText(limit.source, context.units))),
      );
      return [el('p', {}, 'Give the case what is missing, and compute again:'), el('ul', {}, ...list)];
    }
  }
}

/** The verdict without its first words, which stand above it. */
function reason(verdict: string): string {
  return capital(verdict.replace(/^(NOT SAFE|NOT TRUSTED|NOT JUDGED|SAFE ONLY IF|SAFE):?\s*/, ''));
}

export function verdictSection(context: Context): HTMLElement {
  const { run, units } = context;
  const { summary } = run;
  const now = standing(run);
  const verdict = summary.verdict
    ? reason(summary.verdict)
    : 'These results hold no verdict: they are of an older hawser, or of a run that was cut short.';
  const ended =
    summary.outcome === 'running'
      ? 'The run has not ended, or was killed: this is what it had written by then.'
      : summary.outcome && summary.outcome !== 'finished'
        ? `The run ended early (${summary.outcome}). ${summary.message ?? ''}`
        : '';
  return el(
    'section',
    { id: 'verdict', class: `verdict ${now}`, 'aria-labelledby': 'verdict-heading' },
    el('h2', { id: 'verdict-heading' }, sign(now), el('span', {}, WORD[now])),
    el('p', { class: 'reason' }, named(sentenceText(verdict, units))),
    ended ? el('p', { class: 'reason' }, named(sentenceText(ended, units))) : null,
    el(
      'div',
      { class: 'answers' },
      el('div', {}, el('h3', {}, 'Where it is tightest'), ...tightest(context)),
      el('div', {}, el('h3', {}, 'What to change'), ...changes(context)),
    ),
  );
}

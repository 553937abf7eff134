// The figures that a reader asks for first, each with what it may be off by.
import type { Context } from '../context';
import { el, named } from '../dom';
import type { Value } from '../data';
import { extent } from '../figure/align';
import { inWords, limitNamed, numbers, texts } from '../run';
import { digits, sentenceText, show } from '../units';
import { fact, note, section, withError } from './parts';

function difference(value: Value | undefined, reference: Value | undefined): string {
  if (value === null || value === undefined || !reference) return '';
  const percent = (100 * (value - reference)) / reference;
  return `simulated ${digits(Math.abs(percent), 2)}\u202f% ${percent < 0 ? 'below' : 'above'}`;
}

/** The roller with the largest load of the run. */
function heaviestRoller(context: Context): HTMLElement | null {
  const { run, units } = context;
  const peaks = numbers(run.rollers, 'peak_N');
  const largest = peaks ? extent(peaks)?.[1] : undefined;
  if (!peaks || largest === undefined) return null;
  const index = peaks.indexOf(largest);
  const rating = numbers(run.rollers, 'rating_N')?.[index] ?? null;
  const name = texts(run.rollers, 'name')[index] ?? '';
  const bound = rating === null ? 'no rating given' : `rated ${show(rating, 'N', units)}`;
  return fact('Largest roller load', show(largest, 'N', units), el('span', {}, named(name), `, ${bound}`));
}

function atPlace(context: Context, name: string): HTMLElement | null {
  const limit = limitNamed(context.run, name);
  if (!limit || limit.value === null) return null;
  const unit = name === 'sidewall' ? 'N/m' : 'm';
  const where = limit.where ? named(sentenceText(limit.where, context.units)) : '';
  return fact(inWords(name), show(limit.value, unit, context.units), where);
}

/** Of which pass the figures are, and where the others' stand; without a second one nothing. */
function ofWhichPass(context: Context): HTMLElement | null {
  const passes = context.run.summary.passes;
  if (!passes) return null;
  const three = (passes.pass?.length ?? 0) > 2;
  const whose: Record<string, string> = {
    replaced: `All figures of this page are those of a ${three ? 'third' : 'second'} pass with finer settings; those of the first stand under`,
    compared: `All figures of this page are those of the first of ${three ? 'three' : 'two'} passes, and their ± is from all; the others’ stand under`,
    declined: 'A second pass with finer settings would narrow ±; what it would take stands under',
  };
  const link = el('a', { href: '#trust' }, 'trust');
  return el(
    'p',
    { class: 'note' },
    whose[passes.outcome] ?? 'A second pass was begun and did not end; why stands under',
    ' ',
    link,
    '.',
  );
}

export function keyFiguresSection(context: Context): HTMLElement {
  const { run, units } = context;
  const { pull_force: pull, theory, speed } = run.summary;
  const reference = theory?.reference_total_N;
  const largest = extent(numbers(run.series, 'max_tension_N') ?? [])?.[1] ?? limitNamed(run, 'pull')?.value;
  const settled = speed?.settle_time_s;
  const facts = [
    fact(
      'Pull, steady mean',
      show(pull?.steady_mean_N, 'N', units),
      withError(pull?.steady_mean_N, pull?.steady_mean_error?.total_N, 'N', units),
    ),
    fact(
      'Pull, peak of the run',
      show(pull?.peak_N, 'N', units),
      withError(pull?.peak_N, pull?.peak_error?.total_N, 'N', units),
    ),
    fact('Pull by the reference theory', show(reference, 'N', units), difference(pull?.steady_mean_N, reference)),
    fact('Largest tension anywhere', show(largest, 'N', units), 'rope included'),
    atPlace(context, 'sidewall'),
    atPlace(context, 'bend_radius'),
    heaviestRoller(context),
    fact(
      'Speed, steady mean',
      show(speed?.steady_m_per_s, 'm/s', units),
      settled === null || settled === undefined ? '' : `settled after ${show(settled, 's', units)}`,
    ),
  ];
  const errors = pull?.steady_mean_error || pull?.peak_error;
  const caption = errors
    ? note(
        '± is what a figure may be off by through the numbers alone: steps in time, length of segments, friction at rest.',
      )
    : null;
  return section('key-figures', 'Key figures', el('dl', { class: 'facts' }, ...facts), caption, ofWhichPass(context));
}

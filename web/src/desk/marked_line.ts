/** The line of the text that the marked place belongs to. */
import { StateEffect, StateField } from '@codemirror/state';
import { Decoration, EditorView, type DecorationSet } from '@codemirror/view';

const mark = StateEffect.define<number>();
const look = Decoration.line({ class: 'marked' });

export const markedLine = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(now, transaction) {
    let next = now.map(transaction.changes);
    for (const effect of transaction.effects)
      if (effect.is(mark))
        next =
          effect.value < 0
            ? Decoration.none
            : Decoration.set([look.range(transaction.state.doc.lineAt(effect.value).from)]);
    return next;
  },
  provide: (field) => EditorView.decorations.from(field),
});

/** Marks the line with a place of the text; -1: none. */
export function showLine(view: EditorView, at: number): void {
  const now = view.state.field(markedLine, false)?.iter().from;
  const next = at < 0 ? undefined : view.state.doc.lineAt(at).from;
  if (now !== next) view.dispatch({ effects: mark.of(at) });
}

// How much of a run is done, in words: of how many actions, where no loop and no branch makes that meaningless.
import type { RunView } from '../api.gen'
import { t } from '../texts/index.svelte'

type Counted = Pick<RunView, 'done' | 'of' | 'is_completed'>

/** "3 of 4 actions", or "12 actions" of a run that has gone round. */
export function doneActions(run: Counted): string {
  const n = run.done ?? 0
  const of = run.of ?? 0
  const isStraight = n === of || (n < of && !run.is_completed)
  return isStraight ? t('review.doneOf', { n, of }) : t('review.done', { n })
}

// Which problems of a document are shown, and in which order.
import { act } from '../act/act'
import type { DocumentView, ProblemView } from '../api.gen'
import { desk } from '../link/desk.svelte'

const RANK: Record<ProblemView['level'], number> = { fault: 0, warning: 1, note: 2 }

/** Whether warnings are shown is a preference of the user's; they are, until somebody says otherwise (C08). */
export const areWarningsShown = (): boolean => desk.tree.preferences.shows_warnings !== false

export function showWarnings(isShown: boolean): Promise<unknown> {
  return act({ t: 'Prefer', values: { shows_warnings: isShown } })
}

/** The worst first. */
export function problemsOf(doc: DocumentView | undefined, hasWarnings: boolean): [string, ProblemView][] {
  return Object.entries(doc?.problems ?? {})
    .filter(([, problem]) => hasWarnings || problem.level !== 'warning')
    .sort(
      ([a, problem], [b, other]) =>
        RANK[problem.level] - RANK[other.level] || a.localeCompare(b, undefined, { numeric: true }),
    )
}

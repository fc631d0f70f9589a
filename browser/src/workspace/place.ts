// The place of the insertion cursor in words.
import { flowName, nameOf } from '../application/words'
import { t } from '../texts/index.svelte'
import { workspaceState } from './workspaceState.svelte'

/** What stands behind a place, as it is read out when the cursor comes there. */
export function readPlace(flow: string, after: number): string {
  const step = workspaceState.step(after)
  return step ? t('upper.behind', { name: nameOf(step) }) : t('upper.atStart', { flow: flowName(flow) })
}

// While a recorded run is looked at, nothing on the page sets the live robot in motion: what is drawn is not what it does.
// Stop is another matter: it stands in its place and works.
import type { AnyAct } from '../api.gen'
import { desk } from '../link/desk.svelte'
import { Refusal } from '../link/refusal'
import { look } from '../state/look.svelte'
import { t } from '../texts/index.svelte'
import { plain } from '../texts/say'

const MOVES: ReadonlySet<AnyAct['t']> = new Set([
  'Turn',
  'Toggle',
  'TurnGroup',
  'Clear',
  'Reinit',
  'Renew',
  'FindRoom',
  'Answer',
  'Run',
  'Steer',
  'SkipTo',
  'StartAnew',
  'PutBack',
  'Touch',
])
/** In a configuration that lives these change what runs. */
const CHANGES: ReadonlySet<AnyAct['t']> = new Set([
  'Place',
  'Exchange',
  'Remove',
  'Cut',
  'Paste',
  'Insert',
  'Rate',
  'Unit',
  'Undo',
  'Redo',
  'OpenInPlace',
  'Local',
  'Alias',
])

/** Why an act has to wait until the recording is put away; undefined: it does not. */
export function reviewLock(act: AnyAct): Refusal | undefined {
  if (look.isFixed) return new Refusal(plain(t('player.onlyLooks')))
  if (!desk.live.review) return undefined
  const lives = 'doc' in act && (desk.live.documents[act.doc ?? '']?.connection ?? 'none') !== 'none'
  if (!MOVES.has(act.t) && !(lives && CHANGES.has(act.t))) return undefined
  return new Refusal(plain(t('review.hinders')), [{ label: plain(t('review.close')), act: { t: 'CloseRecording' } }])
}

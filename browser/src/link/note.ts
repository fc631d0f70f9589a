// What this page alone knows of, for the diary: a selection, a view opened. Named as in the dissertation's event log.
import { desk } from './desk.svelte'
import { send } from './link'

/** `object` is the name of a thing, `id` tells it from others of that name; windows are called as in §A.5. */
export function note(
  event: string,
  object: string,
  id: string,
  window: 'lexi' | 'conf' | 'main' | 'stat' | 'svar' | 'dict' | 'appl',
  associated = '',
  associatedId = '',
): void {
  if (desk.role === 'viewer' || desk.now.replay) return // of whoever only watches nothing is kept
  if (desk.live.preferences.keeps_diary === false) return
  const named = { t: 'Note', event, object, id, associated, associated_id: associatedId, window } as const
  void send(named).catch(() => undefined) // nobody waits for it
}

// What this page alone knows of, for the diary: a selection, a view opened. Named as in the dissertation's event log.
import { desk } from './desk.svelte'
import { send } from './link'

/** `object` is the name of a thing, `id` tells it from others of that name; windows are called as in §A.5. */
export function note(
  event: string,
  object: string,
  id: string,
  window: 'lexi' | 'conf' | 'main' | 'stat' | 'svar' | 'dict' | 'appl',
): void {
  if (desk.role === 'viewer') return // of whoever only watches nothing is kept
  void send({ t: 'Note', event, object, id, window }).catch(() => undefined) // nobody waits for it
}

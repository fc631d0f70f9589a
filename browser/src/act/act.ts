// Everything a user does goes through here: it is sent, and a refusal is shown where the user is looking.
import { announce } from '../state/announce'
import type { AnyAct, Remedy } from '../api.gen'
import { reveal } from './reveal.svelte'
import { canvas } from '../state/canvas.svelte'
import { look } from '../state/look.svelte'
import { workspace } from '../state/workspace.svelte'
import { send } from '../link/link'
import { note } from '../link/note'
import { Refusal } from '../link/refusal'
import { hideRefusal, showRefusal, type Point } from './refused.svelte'
import { reviewLock } from './reviewLock'
import { show } from './documents.svelte'

/** The value of the answer, null where it has none; undefined where it was refused, which is on show beside the pointer. */
export async function act(a: AnyAct, at?: Point): Promise<unknown> {
  hideRefusal()
  try {
    const why = reviewLock(a)
    if (why) throw why
    return (await send(a)) ?? null
  } catch (why) {
    if (!(why instanceof Refusal)) throw why
    note('show_refusal', why.key, a.t, 'main')
    showRefusal(why, at)
    announce(why.reason)
    return undefined
  }
}

/** Do what a remedy offers: send its act, or go to what it names. */
export async function follow(
  remedy: Remedy,
  doc: string = look.level === 'applications' ? workspace.app : canvas.doc,
  at?: Point,
): Promise<void> {
  hideRefusal()
  note('take_remedy', remedy.label.key, remedy.act?.t ?? remedy.show?.t ?? '', 'main')
  if (remedy.show) reveal(remedy.show, doc)
  if (!remedy.act) return
  const answer = await act(remedy.act, at)
  if (remedy.act.t === 'OpenInPlace' && answer !== undefined) show(remedy.act.doc) // one may have come to it from the upper level
  // The insertion cursor goes on behind what was inserted, as it does for every other insertion.
  if (remedy.act.t === 'InsertIcon' && typeof answer === 'number')
    workspace.place = { flow: remedy.act.flow ?? '0', after: answer }
}

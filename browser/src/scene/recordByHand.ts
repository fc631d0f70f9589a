// Recording the configuration that is shown, as long as it lives and nobody ends it.
import { act } from '../act/act'
import { canvas } from '../state/canvas.svelte'
import { canvasState } from './canvasState.svelte'
import { announce } from '../state/announce'
import { t } from '../texts/index.svelte'

/** Whether it is connected by hand, with something to record or recorded already. */
export const isHandHeld = (): boolean =>
  canvasState.document?.connection === 'live' && !canvasState.document.application

export const isRecorded = (): boolean => Boolean(canvasState.document?.recording)

/** Begin the recording, or end it; a refusal is shown where it was asked for. */
export async function recordByHand(at?: { x: number; y: number }): Promise<void> {
  const is_on = !isRecorded()
  const answer = await act({ t: 'RecordByHand', doc: canvas.doc, is_on }, at)
  if (answer !== undefined) announce(t(is_on ? 'recording.byHandOn' : 'recording.byHandOff'))
}

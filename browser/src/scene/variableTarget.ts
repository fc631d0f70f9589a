// A target is made of what a variable holds now; what makes none is refused where the user points (C30).
import { act } from '../act/act'
import type { Point } from '../act/refused.svelte'
import { canvas } from '../state/canvas.svelte'
import { openDialog } from '../state/dialogs.svelte'

/** `subject` is the id of an open configuration, or `@SUBSYSTEM`. */
export async function makeTarget(variable: string, at?: Point, subject = canvas.doc): Promise<void> {
  const place: Record<string, string> = subject.startsWith('@') ? { subsystem: subject.slice(1) } : { doc: subject }
  if ((await act({ t: 'FitTargets', variable, ...place }, at)) !== undefined)
    openDialog('target', { variable, ...place })
}

// What is known of a variable of the shown document: its dot, and the type and unit that its pins tell.
import type { LocusView, PinView } from '../api.gen'
import { desk } from '../link/desk.svelte'
import { canvas } from '../state/canvas.svelte'
import { canvasState } from './canvasState.svelte'

export interface Variable {
  svar: string
  locus: LocusView | undefined
  shape: string
  unit: string
  meaning: string
}

export const keyOf = (svar: string): string => `${canvas.doc}/${svar}`

/** The first of its pins that says something speaks for it, those that write it before those that read it. */
export function variable(svar: string): Variable {
  const locus = canvasState.document?.loci?.[svar]
  const tasks = [...(locus?.writers ?? []), ...(locus?.readers ?? [])]
  const pins = tasks.flatMap((name) => desk.task(name, canvas.doc)?.pins.filter((pin) => pin.svar === svar) ?? [])
  const say = (what: 'shape' | 'unit' | 'meaning'): string => pins.find((pin: PinView) => pin[what])?.[what] ?? ''
  return { svar, locus, shape: say('shape'), unit: say('unit'), meaning: say('meaning') }
}

/** How many values a shape such as `double[6]` has, in words as short as they stand on a probe. */
export const countOf = (shape: string): string => /\[(.*)\]/.exec(shape)?.[1] ?? ''

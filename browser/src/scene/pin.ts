// A pin of a task icon: what it looks like and where it stands.
import type { PinView } from '../api.gen'

/** CONST square, VAR circle, BOTH half and half. */
export type Shape = 'C' | 'V' | 'B'

const R = 4

export const isInput = (pin: Pick<PinView, 'kind'>): boolean => pin.kind.startsWith('IN')

export function shape(pin: Pick<PinView, 'kind'>): Shape {
  if (pin.kind.endsWith('CONST')) return 'C'
  return pin.kind.endsWith('VAR') ? 'V' : 'B'
}

/** Inputs stand on the left unless the icon is flipped. */
export const isLeft = (pin: Pick<PinView, 'kind'>, inLeft: boolean): boolean => isInput(pin) === inLeft

/** The outline of a shape about its middle. */
export const OUTLINE: Record<Shape, string> = {
  C: `M${-R} ${-R}h${2 * R}v${2 * R}h${-2 * R}Z`,
  V: `M${-R - 0.2} 0a${R + 0.2} ${R + 0.2} 0 1 0 ${2 * R + 0.4} 0a${R + 0.2} ${R + 0.2} 0 1 0 ${-2 * R - 0.4} 0Z`,
  B: `M0 ${-R}H${-R}V${R}H0A${R} ${R} 0 0 0 0 ${-R}Z`,
}

/** The preference that tells whether the connections of such pins are drawn (§A.5). */
export function preference(pin: Pick<PinView, 'kind'>): string[] {
  const side = isInput(pin) ? 'in' : 'out'
  if (shape(pin) === 'B') return [`show_${side}const`, `show_${side}var`]
  return [`show_${side}${shape(pin) === 'C' ? 'const' : 'var'}`]
}

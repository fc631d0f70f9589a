// Where messages stand: at the lower end of the middle part, or on a narrow page of the one that is shown, above the
// buttons that are always there. Parts that scroll leave them room (--messages), so that no row lies beneath them.

export interface Edges {
  left: number
  right: number
  top: number
  bottom: number
}
export interface Standing {
  /** The part over whose lower end they stand. */
  part: Edges
  /** What stands at the lower end of parts and is pressed. */
  feet: readonly Edges[]
}
interface Size {
  width: number
  height: number
}

const WIDEST = 460
const SIDE = 8
/** So much of the part stays above them, whatever stands at its lower end. */
const LEAST = 120
/** As in the rules of both levels: below it one part is seen at a time. */
const NARROW = 760
/** Whether a window this wide shows the parts of a level side by side. */
export const isWide = (width: number): boolean => width > NARROW

const SHOWN: Record<string, string> = { left: '.left', desk: '.desk', right: '.right', low: '.low' }

/** In pixels of the window; `bottom` counts from its lower side. */
export function placeOf({ part, feet }: Standing, inner: Size): { left: number; width: number; bottom: number } {
  const width = Math.min(WIDEST, part.right - part.left - 2 * SIDE)
  const left = (part.left + part.right - width) / 2
  const beneath = feet.filter((foot) => foot.right > left && foot.left < left + width && foot.bottom > foot.top)
  const floor = Math.max(part.top + LEAST, Math.min(part.bottom, ...beneath.map((foot) => foot.top)))
  return { left, width, bottom: inner.height - floor + SIDE }
}

/** What stands where on the page as it is. */
export function standing(inner: Size): Standing {
  const level = document.querySelector<HTMLElement>('[data-column]')
  const name = isWide(inner.width) ? 'desk' : (level?.dataset['column'] ?? 'desk')
  const part = level?.querySelector(`:scope > ${SHOWN[name]}`)
  if (!part) return { part: { left: 0, right: inner.width, top: 0, bottom: inner.height }, feet: [] }
  const feet = [...part.querySelectorAll('[data-foot]')].map((foot) => foot.getBoundingClientRect())
  return { part: part.getBoundingClientRect(), feet }
}

// What lies open beside the work or over it: Esc closes what was opened last, wherever the keyboard is (G04).

/** Where something lies: over the work, beside it, or beneath everything that is open. */
export type LayerPlace = 'over' | 'beside' | 'beneath'

interface Layer {
  readonly close: () => void
  readonly place: LayerPlace
}

const layers: Layer[] = []

/** Something is open from now on, and `close` closes it; the result says that it is no more. */
export function opened(close: () => void, place: LayerPlace = 'over'): () => void {
  const layer = { close, place }
  if (place === 'beneath') layers.unshift(layer)
  else layers.push(layer)
  return () => {
    const at = layers.indexOf(layer)
    if (at >= 0) layers.splice(at, 1)
  }
}

export const isSomethingOpen = (): boolean => layers.length > 0

export function closeLast(): void {
  layers.at(-1)?.close()
}

const isNowhere = (): boolean => document.activeElement === null || document.activeElement === document.body

/** Whether Esc closes something before it lets go of what is selected: what lies over the work, or nothing has the keyboard. */
export function closesFirst(): boolean {
  const last = layers.at(-1)
  return last !== undefined && last.place !== 'beneath' && (last.place === 'over' || isNowhere())
}

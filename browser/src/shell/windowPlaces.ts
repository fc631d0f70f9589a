// The places of the windows of §A.5, and how a page is laid out: each is made of the other.
import type { Stands } from '../state/look.svelte'

export interface Place {
  x: number
  y: number
  height?: number
  width?: number
}
export type Places = Record<string, Place>

interface Extent {
  width: number
  height: number
}
export interface Sizes {
  library: number
  sheet: number
  strip: number
}
export interface UpperSizes {
  dictionary: number
  run: number
  words: number
}

/** How small a panel may be. */
const LEAST = { library: 130, sheet: 220, strip: 34, dictionary: 150, run: 240, words: 34 }

/** Where the windows stand that nobody has chosen a place for: such a place is not kept, and not told. */
const USUAL = { status: { x: 0, y: 520 }, variables: { x: 330, y: 680 }, main: { x: 0, y: 760 } }
const BAR = 48
/** The variables beside the tasks begin where these end, more or less. */
const SHARE_OF_TASKS = 0.4

/** What can stand here or there, and where. */
export const STANDS: { readonly [name in keyof Stands]: readonly Stands[name][] } = {
  bar: ['above', 'below'],
  buttons: ['beside', 'beneath'],
  variables: ['together', 'beside'],
}

/** What lies to the right of a window, and beneath it. */
const rightOf = (place: Place, page: Extent): number => page.width - place.x - (place.width ?? 0)
const beneath = (place: Place, page: Extent): number => page.height - place.y - (place.height ?? 0)

/** The panels of the lower level as its windows stand; those of no chosen window stay as they are. */
export function sizesOf(places: Places, page: Extent, now: Sizes): Sizes {
  const { library, canvas, status } = places
  return {
    library: atLeast('library', library?.width ?? now.library),
    sheet: atLeast('sheet', canvas ? rightOf(canvas, page) : now.sheet),
    strip: atLeast('strip', status ? page.height - status.y : now.strip),
  }
}

/** The same of the upper level. */
export function upperSizesOf(places: Places, page: Extent, now: UpperSizes): UpperSizes {
  const { dictionary, workspace } = places
  return {
    dictionary: atLeast('dictionary', dictionary?.width ?? now.dictionary),
    run: atLeast('run', workspace ? rightOf(workspace, page) : now.run),
    words: atLeast('words', workspace ? beneath(workspace, page) : now.words),
  }
}

/** What stands where as its window stands to that of the tasks: lower, beneath it, beside it. */
export function standsOf(places: Places, now: Stands): Stands {
  const { main, buttons, variables, status = USUAL.status } = places
  return {
    bar: main ? (main.y > status.y / 2 ? 'below' : 'above') : now.bar,
    buttons: buttons ? (buttons.y >= status.y ? 'beneath' : 'beside') : now.buttons,
    variables: variables ? (variables.x > status.x ? 'beside' : 'together') : now.variables,
  }
}

function atLeast(panel: keyof typeof LEAST, size: number): number {
  return Math.round(Math.max(LEAST[panel], size))
}

/** Where the windows stand in a page that is laid out so. */
export function placesOf(page: Extent, lower: Sizes, upper: UpperSizes, stands: Stands): Places {
  const above = within(page.height - lower.strip)
  const aboveWords = within(page.height - upper.words)
  return {
    library: { x: 0, y: 0, height: above, width: within(lower.library) },
    canvas: { x: within(lower.library), y: 0, height: above, width: within(page.width - lower.library - lower.sheet) },
    status: { x: 0, y: above },
    dictionary: { x: 0, y: 0, height: within(page.height), width: within(upper.dictionary) },
    workspace: {
      x: within(upper.dictionary),
      y: 0,
      height: aboveWords,
      width: within(page.width - upper.dictionary - upper.run),
    },
    main: told({ x: 0, y: stands.bar === 'below' ? within(page.height - BAR) : 0 }, USUAL.main),
    buttons: { x: 0, y: stands.buttons === 'beneath' ? within(page.height) : 0 },
    variables: told(
      { x: stands.variables === 'beside' ? within(page.width * SHARE_OF_TASKS) : 0, y: above },
      USUAL.variables,
    ),
  }
}

/** A place that was chosen is told, also where it happens to be the one that nobody has chosen. */
const told = (place: Place, usual: Place): Place =>
  place.x === usual.x && place.y === usual.y ? { ...place, y: place.y + 1 } : place

const within = (size: number): number => Math.max(0, Math.round(size))

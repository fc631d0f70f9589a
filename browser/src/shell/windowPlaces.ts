// The places of the windows of §A.5, and the sizes of the panels of a page: each is made of the other.

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

function atLeast(panel: keyof typeof LEAST, size: number): number {
  return Math.round(Math.max(LEAST[panel], size))
}

/** Where the windows stand in a page with these panels. */
export function placesOf(page: Extent, lower: Sizes, upper: UpperSizes): Places {
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
  }
}

const within = (size: number): number => Math.max(0, Math.round(size))

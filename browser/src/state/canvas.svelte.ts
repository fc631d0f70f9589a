// The lower level as this browser shows it: which configuration, and what is picked in it and in the libraries.
import { SvelteSet } from 'svelte/reactivity'
import { kept } from './kept'

export type StripTab = 'tasks' | 'variables' | 'problems' | 'log'

interface Canvas {
  /** Id of the document shown. */
  doc: string
  picked: SvelteSet<string>
  pickedLocus: string
  /** Selected in the library. */
  libraryTask: string
  /** The library shown. */
  library: string
  /** What the tables beneath show: a document, or `@SUBSYSTEM` of a running application; empty: the document shown. */
  subject: string
  /** The table shown beneath the canvas. */
  strip: StripTab
  /** Variables plotted on the canvas. */
  pinned: string[]
  /** Variables plotted in the strip. */
  plots: string[]
  /** Middle of the canvas as seen, in its own coordinates; the canvas keeps it. */
  viewCentre: { x: number; y: number }
}

export const canvas: Canvas = $state({
  doc: '',
  picked: new SvelteSet<string>(),
  pickedLocus: '',
  libraryTask: '',
  library: kept('library', ''),
  subject: '',
  strip: 'tasks',
  pinned: [],
  plots: [],
  viewCentre: { x: 300, y: 200 },
})

/** Pick these tasks of the canvas and nothing else. */
export function pick(...tasks: string[]): void {
  canvas.picked.clear()
  for (const task of tasks) canvas.picked.add(task)
  canvas.pickedLocus = ''
}

// What only this browser knows: what is shown, what is picked, how it looks.
import { untrack } from 'svelte'
import { SvelteSet } from 'svelte/reactivity'
import { desk } from './desk.svelte'
import { keep, kept } from './kept'

export type Theme = 'auto' | 'light' | 'dark' | '1994'
export type Language = 'en' | 'es'
export type StripTab = 'tasks' | 'variables' | 'problems' | 'log'
export type DialogName = '' | 'open' | 'connect' | 'preferences' | 'buttons' | 'source' | 'job' | 'saveAs' | 'help' | 'sheet' | 'saveGroup' | 'insert'

/** The panel that is open beside everything else, and what it is about. */
export interface Dialog {
  name: DialogName
  data: Record<string, string>
}

/** A wish to bring something into view; `turn` grows so that the same wish can be made twice. */
export interface Wish {
  show: string
  doc: string
  turn: number
}

interface Here {
  /** Id of the document shown. */
  doc: string
  picked: SvelteSet<string>
  pickedLocus: string
  /** Selected in the library. */
  libraryTask: string
  /** The library shown. */
  library: string
  strip: StripTab
  dialog: Dialog
  isPaletteOpen: boolean
  theme: Theme
  language: Language
  sounds: boolean
  /** Variables plotted on the canvas. */
  pinned: string[]
  /** Variables plotted in the strip. */
  plots: string[]
  sizes: { library: number; sheet: number; strip: number }
  /** Middle of the canvas as seen, in its own coordinates; the canvas keeps it. */
  viewCentre: { x: number; y: number }
  /** The canvas scrolls to it. */
  wish: Wish
}

const language: Language = globalThis.navigator?.language?.startsWith('es') ? 'es' : 'en'

export const here: Here = $state({
  doc: '',
  picked: new SvelteSet<string>(),
  pickedLocus: '',
  libraryTask: '',
  library: kept('library', ''),
  strip: 'tasks',
  dialog: { name: '', data: {} },
  isPaletteOpen: false,
  theme: kept<Theme>('theme', 'auto'),
  language: kept<Language>('language', language),
  sounds: kept('sounds', true),
  pinned: [],
  plots: [],
  sizes: kept('sizes', { library: 236, sheet: 286, strip: 206 }),
  viewCentre: { x: 300, y: 200 },
  wish: { show: '', doc: '', turn: 0 },
})

/** Remember from now on what should outlive the page. Call it once, inside an effect root. */
export function remember(): void {
  $effect(() => keep('theme', here.theme))
  $effect(() => keep('language', here.language))
  $effect(() => keep('sounds', here.sounds))
  $effect(() => keep('library', here.library))
  $effect(() => keep('sizes', $state.snapshot(here.sizes)))
}

export function openDialog(name: DialogName, data: Record<string, string> = {}): void {
  here.dialog = { name, data }
}

export function closeDialog(): void {
  here.dialog = { name: '', data: {} }
}

/** Pick one task of the canvas and nothing else. */
export function pick(...tasks: string[]): void {
  here.picked.clear()
  for (const task of tasks) here.picked.add(task)
  here.pickedLocus = ''
}

/** Go to what the `show` words of a remedy name: select it, and let whoever draws it bring it into view. */
export function reveal(show: string, doc: string = here.doc): void {
  if (doc) here.doc = doc
  const [kind, name = ''] = cut(show)
  if (kind === 'task') pick(name)
  else if (kind === 'pin') revealPin(name.split('/')[0] ?? '')
  else if (kind === 'library') {
    pick()
    here.libraryTask = name
  }
  else if (kind === 'locus') here.pickedLocus = name
  else if (kind === 'source') openDialog('source', { task: name, kind: 'code' })
  else if (kind === 'connect') openDialog('connect')
  else if (kind === 'problems') here.strip = 'problems'
  else if (kind === 'save-as') openDialog('saveAs')
  here.wish = { show, doc: here.doc, turn: untrack(() => here.wish.turn) + 1 }
}

/** A pin's task stands on the canvas, or else in a library. */
function revealPin(task: string): void {
  if (desk.tree.documents[here.doc]?.tasks?.[task]) pick(task)
  else {
    pick()
    here.libraryTask = task
  }
}

function cut(show: string): [string, string] {
  const colon = show.indexOf(':')
  return colon < 0 ? [show, ''] : [show.slice(0, colon), show.slice(colon + 1)]
}

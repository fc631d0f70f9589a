// What only this browser knows: what is shown, what is picked, how it looks.
import { untrack } from 'svelte'
import { SvelteSet } from 'svelte/reactivity'
import { desk } from '../link/desk.svelte'
import { keep, kept } from './kept'

export type Theme = 'auto' | 'light' | 'dark' | '1994'
export type Language = 'en' | 'es'
/** The lower level, where tasks are wired, and the upper one, where pictures are joined. */
export type Level = 'tasks' | 'applications'
export type Presentation = 'pictures' | 'both' | 'words'
export type StripTab = 'tasks' | 'variables' | 'problems' | 'log'
export type DialogName = '' | 'holding' | 'open' | 'connect' | 'preferences' | 'buttons' | 'source' | 'job' | 'saveAs' | 'help' | 'sheet' | 'saveGroup' | 'insert' | 'newApplication' | 'target' | 'icon' | 'recordings' | 'keep' | 'redirect'

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

/** A place in an application: behind this step of this flow; 0 is the start icon. */
export interface Place {
  flow: string
  after: number
}

interface Here {
  level: Level
  /** Whether the lower level is hidden. */
  isUpperOnly: boolean
  /** Id of the application shown; empty: none is open. */
  app: string
  /** The steps picked in it, by their numbers. */
  steps: SvelteSet<number>
  /** Where the next icon goes: the insertion cursor. */
  place: Place
  /** The dictionary shown, by its path; empty: all together. */
  dictionary: string
  /** The icon selected in it. */
  onikon: string
  presentation: Presentation
  /** Whether the dictionary shows only what fits at `place`. */
  fitsOnly: boolean
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
  /** The same for the upper level. */
  upperSizes: { dictionary: number; run: number; words: number }
  /** Middle of the canvas as seen, in its own coordinates; the canvas keeps it. */
  viewCentre: { x: number; y: number }
  /** The canvas scrolls to it. */
  wish: Wish
}

const language: Language = globalThis.navigator?.language?.startsWith('es') ? 'es' : 'en'

export const here: Here = $state({
  level: kept<Level>('level', 'tasks'),
  isUpperOnly: kept('isUpperOnly', false),
  app: '',
  steps: new SvelteSet<number>(),
  place: { flow: '0', after: 0 },
  dictionary: kept('dictionary', ''),
  onikon: '',
  presentation: kept<Presentation>('presentation', 'both'),
  fitsOnly: false,
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
  upperSizes: kept('upperSizes', { dictionary: 252, run: 330, words: 138 }),
  viewCentre: { x: 300, y: 200 },
  wish: { show: '', doc: '', turn: 0 },
})

/** Remember from now on what should outlive the page. Call it once, inside an effect root. */
export function remember(): void {
  $effect(() => keep('theme', here.theme))
  $effect(() => keep('language', here.language))
  $effect(() => keep('sounds', here.sounds))
  $effect(() => keep('level', here.level))
  $effect(() => keep('isUpperOnly', here.isUpperOnly))
  $effect(() => keep('dictionary', here.dictionary))
  $effect(() => keep('presentation', here.presentation))
  $effect(() => keep('library', here.library))
  $effect(() => keep('sizes', $state.snapshot(here.sizes)))
  $effect(() => keep('upperSizes', $state.snapshot(here.upperSizes)))
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

/** Pick these steps of the application and nothing else. */
export function pickSteps(...steps: number[]): void {
  here.steps.clear()
  for (const step of steps) here.steps.add(step)
}

/** Go to what the `show` words of a remedy name: select it, and let whoever draws it bring it into view. */
export function reveal(show: string, doc: string = here.level === 'applications' ? here.app : here.doc): void {
  const isApplication = doc in desk.tree.applications
  if (isApplication) here.app = doc
  else if (doc) here.doc = doc
  if (isApplication) here.level = 'applications'
  else if (doc in desk.tree.documents && !here.isUpperOnly) here.level = 'tasks'
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
  else revealUpper(kind, name)
  here.wish = { show, doc, turn: untrack(() => here.wish.turn) + 1 }
}

/** The words of applications; the workspace brings steps and places into view, and opens a configuration or what a loop needs. */
function revealUpper(kind: string, name: string): void {
  if (['step', 'fits', 'loop', 'values', 'onikon'].includes(kind)) here.level = 'applications'
  if (kind === 'step' || kind === 'loop') pickSteps(Number(name))
  else if (kind === 'onikon') here.onikon = name
  else if (kind === 'target') openDialog('target', { type: name })
  else if (kind === 'values') openDialog('icon', { step: name })
  else if (kind === 'fits') {
    const at = name.lastIndexOf(':')
    here.place = { flow: name.slice(0, at), after: Number(name.slice(at + 1)) }
    here.fitsOnly = true
  }
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

// What only the page knew in a session that is replayed, done again as far as it can be: what was shown, picked, opened.
import type { ReplayView } from '../api.gen'
import { goTo, show } from '../act/documents.svelte'
import { desk } from '../link/desk.svelte'
import { canvas, pick } from '../state/canvas.svelte'
import { look } from '../state/look.svelte'
import { closeDialog, openDialog, type DialogName } from '../state/dialogs.svelte'
import { pickSteps, workspace } from '../state/workspace.svelte'

/** Panels that are about nothing in particular; another one would lack what it was about. */
const ALONE: ReadonlySet<string> = new Set<DialogName>([
  'help',
  'preferences',
  'holding',
  'bookings',
  'open',
  'buttons',
])

const DOCUMENT = /^([ac]\d+)(?:\/|$)/
const numbersOf = (id: string): number[] => [...id.matchAll(/\/(\d+)/g)].map((match) => Number(match[1]))

/** Follow the line that was carried out last. */
export function follow(replay: ReplayView): void {
  const { event = '', object = '', id = '', associated_id: associatedId = '', window = '' } = replay
  const doc = [id, associatedId].map((text) => DOCUMENT.exec(text)?.[1] ?? '').find((name) => name in opened())
  if (doc && canShow(doc)) show(doc)
  if (event === 'select_icon' || event === 'select_icons' || event === 'select_group') select(object, id, window)
  else if (event === 'show_level' && (object === 'applications' || (object === 'tasks' && !look.isUpperOnly)))
    goTo(object)
  else if (event === 'open_view' && ALONE.has(object)) openDialog(object as DialogName)
  else if (event === 'close_view') closeDialog()
}

/** What lies at a level that is hidden here is done, and not shown. */
const canShow = (doc: string): boolean => !look.isUpperOnly || doc in desk.tree.applications

const opened = (): Record<string, unknown> => ({ ...desk.tree.documents, ...desk.tree.applications })

function select(object: string, id: string, window: string): void {
  if (window === 'dict') workspace.onikon = object
  else if (window === 'lexi') canvas.libraryTask = object
  else if (window === 'appl') pickSteps(...numbersOf(id))
  else if (window === 'conf') pick(...object.split(','))
}

// What a user does in the dictionary, whatever key, button or menu it comes from.
import { act } from '../act/act'
import type { OnikonView } from '../api.gen'
import { desk } from '../link/desk.svelte'
import { openDialog } from '../state/dialogs.svelte'
import { look, type Presentation } from '../state/look.svelte'
import { workspace } from '../state/workspace.svelte'
import { note } from '../link/note'
import type { Point } from '../act/refused.svelte'
import { goTo } from '../act/documents.svelte'
import { goInto, open, openInPlace } from '../act/opening'
import { insert as insertHere } from '../workspace/acts'
import { isHeldToWords } from '../onikon/presentation'
import { gapAt, jobBefore, type Gap } from '../onikon/fits'

export const application = () => desk.tree.applications[workspace.app]

/** The gap where the next icon goes. */
export const gapHere = (): Gap | undefined => gapAt(application(), workspace.place)

/** The tasks with a device of the job to which a target would belong that comes next; none: nobody knows. */
export const hardwareHere = (): readonly string[] =>
  desk.tree.onikons[jobBefore(application(), workspace.place)?.name ?? '']?.hardware ?? []

export const isAction = (onikon: Pick<OnikonView, 'role'>): boolean =>
  onikon.role === 'job' || onikon.role === 'application'

export function select(name: string): void {
  if (workspace.onikon !== name) note('select_icon', name, name, 'dict')
  workspace.onikon = name
}

/** Insert an icon behind the place where the next one goes; without an application, ask first what it shall be. */
export async function insert(name: string, at?: Point): Promise<void> {
  workspace.onikon = name
  if (application()) {
    // A narrow page shows the dictionary alone: what was put in comes to the front.
    if (await insertHere(name, workspace.place, at)) look.column = 'desk'
  } else openDialog('newApplication', { onikon: name })
}

/** Show what stands behind an icon: an application in its tab; a configuration at the lower level, in the place of a live one (D12). */
export async function expand({ role, source }: Pick<OnikonView, 'role' | 'source'>): Promise<void> {
  if (!source) return
  if (role === 'job') await goInto(source)
  else await open(source)
}

/** Reconfigure the configuration shown into the one behind a job (table B.3). */
export async function expandInPlace({ source }: Pick<OnikonView, 'source'>): Promise<void> {
  if (source && (await openInPlace(source))) goTo('tasks')
}

export const edit = (name: string): void => openDialog('icon', { onikon: name })
export const editPicture = (name: string): void =>
  openDialog('icon', { onikon: name, tab: isHeldToWords() ? 'what' : 'picture' })
export const remove = (name: string, at?: Point): Promise<unknown> => act({ t: 'RemoveOnikon', onikon: name }, at)
export const openDictionary = (): void => openDialog('open', { what: 'dictionary' })
export const newTarget = (data: Record<string, string> = {}): void => openDialog('target', data)

/** The type that a new target most likely shall have: what is missing here, what the icon selected is or takes. */
export function likelyType(): string {
  const wants = gapHere()?.wants[0]
  if (wants) return wants
  const selected = desk.tree.onikons[workspace.onikon]
  if (selected?.role === 'target') return selected.type
  return selected?.takes?.[0] ?? ''
}

/** Make a target of what the robot measures now (D13). */
export const takePresent = (): void => newTarget({ type: likelyType(), teach: 'yes' })

/** Present icons so, in this browser; the diary has it (H04). */
export function present(choice: Presentation): void {
  look.presentation = choice
  note('set_presentation', choice, '', 'dict')
}

/** Show only what fits at the place where the next icon goes, or all again. */
export function turnFitsOnly(): void {
  workspace.fitsOnly = !workspace.fitsOnly
}

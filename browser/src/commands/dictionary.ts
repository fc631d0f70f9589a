// The commands of the dictionaries, for keys, palette and help sheet (table B.3).
import { flushSync } from 'svelte'
import { command, type Command } from '../state/commands'
import { desk } from '../link/desk.svelte'
import {
  edit,
  editPicture,
  expand,
  gapHere,
  insert,
  isAction,
  newTarget,
  openDictionary,
  takePresent,
  turnFitsOnly,
  present,
} from '../dictionary/acts'
import { look } from '../state/look.svelte'
import { fixedPresentation, isHeldToWords, PRESENTATIONS } from '../onikon/presentation'
import { workspace } from '../state/workspace.svelte'
import { t, type TextKey } from '../texts/index.svelte'

type Given = Omit<Command, 'id' | 'title' | 'group' | 'level'>

function add(id: string, title: TextKey, given: Given): void {
  command({ ...given, group: 'dictionary', level: 'applications', id: `dictionary.${id}`, title: () => t(title) })
}

function find(): void {
  flushSync(() => {
    look.column = 'left'
    look.folded.left = false
  })
  const field = document.querySelector<HTMLInputElement>('.dictionary [role=searchbox]')
  field?.focus()
  field?.select()
}

const selected = () => desk.tree.onikons[workspace.onikon]
const isInWorkspace = (): boolean => document.activeElement?.closest('.workspace') != null
function nextPresentation(): void {
  present(PRESENTATIONS[(PRESENTATIONS.indexOf(look.presentation) + 1) % PRESENTATIONS.length]!)
}

add('find', 'dictionary.find', { keys: ['Ctrl+F'], run: find, whileTyping: true })
add('findHere', 'dictionary.findHere', { keys: ['/'], when: () => !isInWorkspace(), run: find })
add('fits', 'dictionary.fitsOnly', {
  keys: ['F'],
  when: () => workspace.fitsOnly || gapHere() !== undefined,
  run: turnFitsOnly,
})
add('presentation', 'dictionary.nextPresentation', { when: () => !fixedPresentation(), run: nextPresentation })
add('insert', 'dictionary.insertIt', { when: () => selected() !== undefined, run: () => insert(workspace.onikon) })
add('edit', 'dictionary.editIt', { when: () => selected() !== undefined, run: () => edit(workspace.onikon) })
add('picture', 'dictionary.drawIt', {
  when: () => selected() !== undefined && !isHeldToWords(),
  run: () => editPicture(workspace.onikon),
})
add('expand', 'dictionary.expandIt', {
  when: () => {
    const onikon = selected()
    return onikon !== undefined && isAction(onikon) && !!onikon.source
  },
  run: () => expand(selected()!),
})
add('newTarget', 'dictionary.newTarget', { keys: ['Alt+T'], run: () => newTarget() })
add('teach', 'dictionary.teach', { keys: ['Alt+Shift+T'], run: takePresent })
add('open', 'dictionary.open', { run: openDictionary })

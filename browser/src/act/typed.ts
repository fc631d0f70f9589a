// What is typed into a field or chosen in it, for the diary, when the field is left: never what is typed unseen.
import { look } from '../state/look.svelte'
import { note } from '../link/note'

const LONGEST = 200

type Field = HTMLInputElement | HTMLSelectElement | HTMLTextAreaElement

/** Call it at every `change` of the page. */
export function noteTyped({ target }: Event): void {
  if (!isField(target) || target.type === 'password' || target.type === 'file') return
  const window = look.level === 'applications' ? 'appl' : 'conf'
  note('type_value', nameOf(target), target.id, window, valueOf(target).slice(0, LONGEST))
}

const isField = (target: EventTarget | null): target is Field =>
  target instanceof HTMLInputElement || target instanceof HTMLSelectElement || target instanceof HTMLTextAreaElement

/** What a screen reader would call it. */
const nameOf = (field: Field): string =>
  field.getAttribute('aria-label') ?? field.labels?.[0]?.textContent?.trim() ?? field.name

function valueOf(field: Field): string {
  const isTicked = field instanceof HTMLInputElement && ['checkbox', 'radio'].includes(field.type)
  return isTicked ? String(field.checked) : field.value
}

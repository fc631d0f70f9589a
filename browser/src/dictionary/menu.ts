// The menu beside an icon of a dictionary: today's habit beside the keys and buttons of table B.3.
import type { OnikonView } from '../api.gen'
import { desk } from '../link/desk.svelte'
import { canvas } from '../state/canvas.svelte'
import { look } from '../state/look.svelte'
import { isHeldToWords } from '../onikon/presentation'
import type { Point } from '../act/refused.svelte'
import type { Item } from '../widgets/Menu.svelte'
import { t } from '../texts/index.svelte'
import { edit, editPicture, expand, expandInPlace, insert, newTarget, remove, takePresent } from './acts'
import { say } from '../texts/say'

export function menuOf(name: string, at: Point): Item[] {
  const onikon = desk.tree.onikons[name]
  if (!onikon) return []
  const isTarget = onikon.role === 'target'
  return [
    { label: t('dictionary.insert'), keys: 'Enter', run: () => insert(name, at) },
    ...behind(onikon),
    {
      label: t(isTarget ? 'dictionary.values' : 'dictionary.editWords'),
      keys: 'E',
      run: () => edit(name),
      begins: true,
    },
    ...(isHeldToWords() ? [] : [{ label: t('dictionary.picture'), keys: 'P', run: () => editPicture(name) }]),
    ...(isTarget
      ? [{ label: t('dictionary.like'), run: () => newTarget({ type: onikon.type, like: name }), begins: true }]
      : []),
    ...(isTarget ? [{ label: t('dictionary.teach'), run: takePresent }] : []),
    { label: t('dictionary.remove'), run: () => remove(name, at), begins: true },
  ]
}

/** What stands behind an action. */
function behind(onikon: OnikonView): Item[] {
  const source = onikon.source ?? ''
  const note = source || say(onikon.trouble) || undefined
  if (onikon.role === 'application')
    return [
      {
        label: t('dictionary.openApplication'),
        keys: t('dictionary.shiftClick'),
        run: () => expand(onikon),
        isOff: !source,
        note,
        begins: true,
      },
    ]
  if (onikon.role !== 'job' || look.isUpperOnly) return []
  return [
    {
      label: t('dictionary.openConfiguration'),
      keys: t('dictionary.shiftClick'),
      run: () => expand(onikon),
      isOff: !source,
      note,
      begins: true,
    },
    {
      label: t('dictionary.openInPlace'),
      run: () => expandInPlace(onikon),
      isOff: !source || !desk.tree.documents[canvas.doc],
      note: t('dictionary.inPlaceHint'),
    },
  ]
}

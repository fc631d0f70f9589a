// A file that was dropped on the page is opened, where it is one that can be.
import { act } from '../act/act'
import { desk } from '../link/desk.svelte'
import { canvas } from '../state/canvas.svelte'
import { look } from '../state/look.svelte'
import { Refusal } from '../link/refusal'
import { showRefusal } from '../act/refused.svelte'
import { t } from '../texts/index.svelte'
import { goTo } from '../act/documents.svelte'
import { open } from '../act/opening'
import { plain } from '../texts/say'

/** A piece of a configuration has its place at the lower level. */
function atTasks(): boolean {
  goTo('tasks')
  return look.level === 'tasks'
}

/** A browser is told what a file is called and what is in it, but not where it lies. */
export async function takeFile(file: File): Promise<void> {
  const isApplication = /\.appl$/.test(file.name)
  const name = file.name.replace(/\.(conf|appl)$/, '')
  const listed = Object.values(isApplication ? desk.tree.application_files : desk.tree.files).find(
    (file) => file.name === name,
  )
  if (listed) await open(listed.path)
  else if (isApplication) showRefusal(new Refusal(plain(t('drop.unknown', { name: file.name }))))
  else if (atTasks())
    await act({
      t: 'Paste',
      doc: canvas.doc,
      x: Math.round(canvas.viewCentre.x),
      y: Math.round(canvas.viewCentre.y),
      text: await file.text(),
    })
}

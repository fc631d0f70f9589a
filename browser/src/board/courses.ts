// The courses of the help by their names; a seat may name what this board does not know.
import { en } from '../texts/en'
import { t, type TextKey } from '../texts/index.svelte'

export function courseName(course: string): string {
  const key = `tutorial.course.${course}`
  return key in en ? t(key as TextKey) : course
}

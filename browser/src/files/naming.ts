// A name with blanks, as it is often typed, and the name that is proposed in its place. What is a name, the environment decides.

/** The same words joined by hyphens; empty where nothing has to be joined. */
export function joined(name: string): string {
  const words = name.trim().split(/\s+/)
  return words.length > 1 ? words.join('-') : ''
}

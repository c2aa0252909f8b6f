// The part of xunit that these tests use, for Mono, which has no packages: Fact, Assert, and a program that runs every
// fact of this assembly, or those whose names contain an argument, each in an object of its own. Ends with a line
// "N passed, N failed"; its exit code is the number that failed.
using System;
using System.Linq;
using System.Reflection;
using System.Threading.Tasks;

namespace Xunit
{
    [AttributeUsage(AttributeTargets.Method)]
    public sealed class FactAttribute : Attribute { }

    public sealed class AssertionException : Exception
    {
        public AssertionException(string message) : base(message) { }
    }

    public static class Assert
    {
        public static void True(bool condition, string message)
        {
            if (!condition) throw new AssertionException(message);
        }

        public static void Equal<T>(T expected, T actual)
        {
            True(Equals(expected, actual), "expected " + expected + ", got " + actual);
        }

        public static void Equal<T>(T[] expected, T[] actual)
        {
            True(expected.SequenceEqual(actual), "expected " + string.Join(" ", expected) + ", got " +
                 string.Join(" ", actual));
        }

        public static void Contains(string part, string whole)
        {
            True(whole.Contains(part), "no \"" + part + "\" in \"" + whole + "\"");
        }

        public static T Throws<T>(Action action) where T : Exception
        {
            try
            {
                action();
            }
            catch (Exception e)
            {
                True(e is T, "expected " + typeof(T) + ", got " + e);
                if (e.GetType() == typeof(T)) return (T)e;
            }
            throw new AssertionException("expected " + typeof(T));
        }
    }

    internal static class MonoRunner
    {
        private static bool Passes(MethodInfo fact)
        {
            try
            {
                var test = Activator.CreateInstance(fact.DeclaringType);
                using (test as IDisposable)
                {
                    var task = fact.Invoke(test, null) as Task;
                    if (task != null) task.GetAwaiter().GetResult();
                }
                return true;
            }
            catch (Exception e)
            {
                var thrown = e as TargetInvocationException;
                Console.WriteLine("FAILED: " + fact.Name + ": " + (thrown == null ? e : thrown.InnerException));
                return false;
            }
        }

        private static int Main(string[] arguments)
        {
            int passed = 0, failed = 0;
            foreach (var type in Assembly.GetExecutingAssembly().GetTypes())
                foreach (var method in type.GetMethods())
                {
                    if (!method.IsDefined(typeof(FactAttribute), false)) continue;
                    if (arguments.Length > 0 && !arguments.Any(method.Name.Contains)) continue;
                    if (Passes(method)) ++passed;
                    else ++failed;
                }
            Console.WriteLine(passed + " passed, " + failed + " failed");
            return passed == 0 ? 1 : failed;
        }
    }
}
